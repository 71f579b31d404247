// SPDX-License-Identifier: BSD-3-Clause
// Typed reading of TOML tables with errors that name file, line and key, and with no key left unread.
// All of toml++ stays in toml_reader.cpp and toml_document.cpp.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wetdeck {

class Expressions;
class TomlDocument;

/// A table of a scene file. Each getter marks its key as known; `finish` rejects the keys nobody asked for.
class TomlTable {
  public:
    bool has(const std::string& key) const;
    /// Whether the entry is there and a text in quotes.
    bool holds_text(const std::string& key) const;
    /// Whether the entry is there and a text that stands for a number, see expressions.hpp.
    bool holds_expression(const std::string& key) const;
    /// That text.
    std::string expression(const std::string& key) const;
    /// Whether the entry is there and a number or an expression, or a table.
    bool is_number(const std::string& key) const;
    bool is_table(const std::string& key) const;

    double number(const std::string& key) const;
    double number_or(const std::string& key, double fallback) const;
    double positive(const std::string& key) const;
    std::optional<double> optional_number(const std::string& key) const;
    bool boolean_or(const std::string& key, bool fallback) const;
    std::string text(const std::string& key) const;
    std::string text_or(const std::string& key, const std::string& fallback) const;
    /// One of the names given, else the error lists them.
    std::string choice(const std::string& key, const std::vector<std::string>& names,
                       const std::optional<std::string>& fallback = std::nullopt) const;
    std::vector<double> numbers(const std::string& key,
                                std::optional<std::size_t> count = std::nullopt) const;
    std::vector<std::vector<double>> number_rows(const std::string& key, std::size_t count) const;
    std::vector<std::string> texts(const std::string& key) const;

    TomlTable table(const std::string& key) const;
    std::optional<TomlTable> optional_table(const std::string& key) const;
    std::vector<TomlTable> tables(const std::string& key) const;
    /// An entry as TOML text, sorted by key; empty where it is not there.
    std::string text_of(const std::string& key) const;
    /// Those of the document.
    const Expressions& expressions() const;
    /// Names of all entries, in the order of the file.
    std::vector<std::string> keys() const;

    /// Throws InputError if an entry of this table was never asked for.
    void finish() const;
    /// Throws InputError "file:line: key 'a.b': message" about an entry of this table.
    [[noreturn]] void fail(const std::string& key, const std::string& message) const;
    /// "file:line: key 'a.b'", as in the messages of `fail`.
    std::string place_of(const std::string& key) const;
    /// Throws for a key that is not there; an unknown one that is its slip of the pen is named instead.
    [[noreturn]] void fail_missing(const std::string& key, const std::string& expected) const;

  private:
    friend class TomlDocument;
    struct Node;
    explicit TomlTable(std::shared_ptr<Node> node) : node_(std::move(node)) {}
    std::shared_ptr<Node> node_;
};

class TomlDocument {
  public:
    /// Parses `text`; `path` is named in errors. Throws InputError.
    TomlDocument(const std::string& text, const std::string& path);
    ~TomlDocument();
    TomlDocument(TomlDocument&&) noexcept;

    /// Which entries of an overlaid table count.
    enum class Overlay { all, of_existing_tables };
    /// Lays the table at the dotted key over the root, entry by entry (a variant over the scene). With
    /// `of_existing_tables`, only those tables in it that the root has (a scheme over the scene).
    void overlay(const std::vector<std::string>& path_to_table, Overlay entries = Overlay::all);
    /// Gives the entry of a dotted key its present name. Returns a note on it for the user, or nothing where
    /// the old name is not used. An entry of the new name is replaced or, if that is not allowed, InputError
    /// thrown.
    std::optional<std::string> rename(const std::string& old_key, const std::string& new_key,
                                      bool may_replace);
    /// The document as a text in which it stands in the table of that path.
    std::string nested_in(const std::vector<std::string>& path_to_table) const;
    /// The entries of an array of tables as text, without the named keys.
    std::string array_text(const std::string& key, const std::vector<std::string>& without) const;
    /// A text in quotes, on one line, and where it stands in the document [bytes], quotes included.
    struct TextValue {
        std::string key;  ///< dotted
        std::string value;
        std::size_t line, begin, end;
    };
    /// The texts that stand under this key in whatever table, as they follow each other.
    std::vector<TextValue> texts_named(const std::string& key) const;

    /// KEY=VALUE from the command line. The value is TOML; a bare word is taken as text.
    void set(const std::string& assignment);
    TomlTable root() const;
    /// The document as it stands, sorted by key.
    std::string resolved() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace wetdeck
