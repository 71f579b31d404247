// SPDX-License-Identifier: BSD-3-Clause
// Thin ownership over the C API of HDF5: files and groups that close themselves, know their place, and turn
// HDF5's error stack into DataError (wrong content) or EnvironmentError (the machine
// refused; a full disk says "disk full").
#pragma once

#include <hdf5.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace wetdeck::hdf5 {

/// An HDF5 identifier, closed with its scope.
class Handle {
  public:
    using Closer = herr_t (*)(hid_t);

    Handle(hid_t id, Closer closer) : id_(id), closer_(closer) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(closer_, other.closer_);
        return *this;
    }
    ~Handle() {
        if (id_ >= 0) closer_(id_);
    }
    hid_t id() const { return id_; }

  private:
    hid_t id_;
    Closer closer_;
};

/// An open file, group or dataset and its place ("runs/a/run.h5 /series/front") for messages.
class Node {
  public:
    Node(Handle handle, std::string place) : handle_(std::move(handle)), place_(std::move(place)) {}
    hid_t id() const { return handle_.id(); }
    const std::string& place() const { return place_; }

  private:
    Handle handle_;
    std::string place_;
};

/// Throws DataError or EnvironmentError, "PLACE: MESSAGE", by what HDF5's error stack says.
[[noreturn]] void fail(const std::string& place, const std::string& message);

/// Passes a non-negative result of the C API on; calls fail() for a negative one.
template <typename Result>
Result check(Result result, const std::string& place, const std::string& message) {
    if (result < 0) fail(place, message);
    return result;
}

/// Takes ownership of an identifier that the C API has just returned.
inline Handle own(hid_t id, Handle::Closer closer, const std::string& place, const std::string& message) {
    return {check(id, place, message), closer};
}

/// A file in memory only, named for messages; `file_image` yields its bytes.
Node create_in_memory(const std::string& name);
std::string file_image(const Node& file);

enum class Access { read, append };

/// Files on disk, without HDF5's own locks: run directories have their own, and with HDF5's nobody could look
/// into a file that is being written.
Node create_file(const std::filesystem::path& path);
Node open_file(const std::filesystem::path& path, Access access);

Node create_group(const Node& parent, const std::string& name);
Node open_group(const Node& parent, const std::string& name);
bool has_link(const Node& parent, const std::string& name);

/// Names of the groups and datasets in a group, and of the attributes of a node, in ascending order.
std::vector<std::string> link_names(const Node& group);
std::vector<std::string> attribute_names(const Node& node);

}  // namespace wetdeck::hdf5
