// SPDX-License-Identifier: BSD-3-Clause
#include "reports/figures/reference_names.hpp"

#include <cctype>

namespace wetdeck::report {
namespace {

constexpr std::size_t longest_name = 42;

bool belongs_to_authors(const std::string& word) {
    return word == "et" || word == "al." || word == "and" || word == "&" ||
           (!word.empty() && std::isupper(static_cast<unsigned char>(word.front())) && word.back() != ',');
}

/// Start of "Authors (year)" in a title, npos if there is none.
std::size_t authors_in(const std::string& title) {
    const auto digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(title[i])) != 0; };
    for (std::size_t open = title.find(" ("); open != std::string::npos; open = title.find(" (", open + 1)) {
        const bool year = open + 6 < title.size() && digit(open + 2) && digit(open + 3) && digit(open + 4) &&
                          digit(open + 5) && title[open + 6] == ')';
        if (!year) continue;
        std::size_t begin = open;
        while (begin > 0) {
            const std::size_t gap = title.rfind(' ', begin - 1);
            const std::size_t word = gap == std::string::npos ? 0 : gap + 1;
            if (!belongs_to_authors(title.substr(word, begin - word))) break;
            begin = word == 0 ? 0 : gap;
        }
        if (begin < open) return title[begin] == ' ' ? begin + 1 : begin;
    }
    return std::string::npos;
}

}  // namespace

std::string reference_name(const std::string& title, const std::string& stem) {
    std::string name = title;
    if (const std::size_t authors = authors_in(name); authors != std::string::npos) {
        name = name.substr(authors);
        if (name.size() > longest_name) name = name.substr(0, name.find(')') + 1);
    } else if (const std::size_t comma = name.find(", "); comma != std::string::npos) {
        name = name.substr(comma + 2);
    }
    static const std::string against = " against ";
    if (const std::size_t begin = name.find(against);
        name.size() > longest_name && begin != std::string::npos)
        name = name.substr(begin + against.size());
    if (name.size() > longest_name) name = name.substr(0, name.find(": "));
    return name.empty() || name.size() > longest_name ? stem : name;
}

}  // namespace wetdeck::report
