// SPDX-License-Identifier: BSD-3-Clause
// Files, groups and errors of HDF5.
#include "validation/store/hdf5_file.hpp"

#include <cstdlib>
#include <cstring>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck::hdf5 {
namespace {

/// HDF5's file drivers describe a failed system call as "..., errno = 28, error message = ...".
herr_t find_error_number(unsigned, const H5E_error2_t* entry, void* found) {
    constexpr const char* mark = "errno = ";
    const char* text = entry->desc != nullptr ? std::strstr(entry->desc, mark) : nullptr;
    if (text != nullptr) *static_cast<int*>(found) = std::atoi(text + std::strlen(mark));
    return 0;
}

/// HDF5 prints its error stack by default, per thread; ours become exceptions instead. Its exit handler
/// closes what a full disk left open and crashes on it: it is not registered.
void silence() {
    [[maybe_unused]] static const herr_t without_exit_handler = H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle access_list(const std::string& place) {
    silence();
    return own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, place, "HDF5 does not start");
}

Handle access_list_without_locks(const std::string& place) {
    Handle list = access_list(place);
    check(H5Pset_file_locking(list.id(), false, true), place, "HDF5 refuses to work without locks");
    return list;
}

/// Names are links inside their group: a path would land elsewhere.
void require_link_name(const Node& parent, const std::string& name) {
    if (name.empty() || name == "." || name.find('/') != std::string::npos) {
        throw DataError(parent.place() + ": '" + name +
                        "' cannot be a name in the file, expected a word without '/'");
    }
}

std::string below(const Node& parent, const std::string& name) {
    const bool is_file = H5Iget_type(parent.id()) == H5I_FILE;
    return parent.place() + (is_file ? " /" : "/") + name;
}

herr_t collect_link(hid_t, const char* name, const H5L_info_t*, void* names) {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
}

herr_t collect_attribute(hid_t, const char* name, const H5A_info_t*, void* names) {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
}

}  // namespace

void fail(const std::string& place, const std::string& message) {
    int error_number = 0;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, find_error_number, &error_number);
    if (error_number == 0 || error_number == ENOENT) {
        throw DataError(place + ": " + (error_number == ENOENT ? "no such file" : message));
    }
    throw EnvironmentError(place + ": " + message + ": " + system_reason(error_number));
}

Node create_in_memory(const std::string& name) {
    const Handle list = access_list(name);
    constexpr std::size_t growth = std::size_t{1} << 20;
    check(H5Pset_fapl_core(list.id(), growth, false), name, "HDF5 cannot build a file in memory");
    return {own(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, list.id()), H5Fclose, name,
                "cannot build the file"),
            name};
}

std::string file_image(const Node& file) {
    const char* message = "cannot finish the file";
    check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), file.place(), message);
    std::string bytes(
        static_cast<std::size_t>(check(H5Fget_file_image(file.id(), nullptr, 0), file.place(), message)),
        '\0');
    check(H5Fget_file_image(file.id(), bytes.data(), bytes.size()), file.place(), message);
    return bytes;
}

Node create_file(const std::filesystem::path& path) {
    const Handle list = access_list_without_locks(path);
    return {own(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, list.id()), H5Fclose, path,
                "cannot create the file"),
            path};
}

Node open_file(const std::filesystem::path& path, Access access) {
    const Handle list = access_list_without_locks(path);
    const unsigned flags = access == Access::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR;
    return {own(H5Fopen(path.c_str(), flags, list.id()), H5Fclose, path, "truncated or not an HDF5 file"),
            path};
}

Node create_group(const Node& parent, const std::string& name) {
    require_link_name(parent, name);
    const std::string place = below(parent, name);
    return {own(H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, place,
                "cannot create the group"),
            place};
}

Node open_group(const Node& parent, const std::string& name) {
    const std::string place = below(parent, name);
    return {own(H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Gclose, place,
                "the group is missing or damaged"),
            place};
}

bool has_link(const Node& parent, const std::string& name) {
    return check(H5Lexists(parent.id(), name.c_str(), H5P_DEFAULT), parent.place(), "damaged group") > 0;
}

std::vector<std::string> link_names(const Node& group) {
    std::vector<std::string> names;
    check(H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect_link, &names), group.place(),
          "damaged group");
    return names;
}

std::vector<std::string> attribute_names(const Node& node) {
    std::vector<std::string> names;
    check(H5Aiterate2(node.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect_attribute, &names),
          node.place(), "damaged attributes");
    return names;
}

}  // namespace wetdeck::hdf5
