// SPDX-License-Identifier: BSD-3-Clause
// Attributes, arrays and growing tables.
#include "validation/store/hdf5_values.hpp"

#include <hdf5_hl.h>

#include <algorithm>
#include <array>
#include <limits>

#include "solver/core/errors.hpp"

namespace wetdeck::hdf5 {
namespace {

constexpr std::size_t compress_from = 512;         // values; shorter arrays gain nothing
constexpr std::size_t values_per_chunk = 1 << 14;  // 128 KiB, well inside HDF5's chunk cache of 1 MiB

std::string attribute_place(const Node& node, const std::string& name) {
    return node.place() + " attribute " + name;
}

Handle text_type(const std::string& place) {
    Handle type = own(H5Tcopy(H5T_C_S1), H5Tclose, place, "cannot describe text");
    check(H5Tset_size(type.id(), H5T_VARIABLE), place, "cannot describe text");
    check(H5Tset_cset(type.id(), H5T_CSET_UTF8), place, "cannot describe text");
    return type;
}

void write_scalar(const Node& node, const std::string& name, hid_t file_type, hid_t memory_type,
                  const void* value) {
    const std::string place = attribute_place(node, name);
    const char* message = "cannot write the attribute";
    const Handle space = own(H5Screate(H5S_SCALAR), H5Sclose, place, message);
    const Handle attribute =
        own(H5Acreate2(node.id(), name.c_str(), file_type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
            place, message);
    check(H5Awrite(attribute.id(), memory_type, value), place, message);
}

Handle open_attribute(const Node& node, const std::string& name) {
    return own(H5Aopen(node.id(), name.c_str(), H5P_DEFAULT), H5Aclose, attribute_place(node, name),
               "the attribute is missing or damaged");
}

Handle type_of(const Handle& attribute, const std::string& place) {
    return own(H5Aget_type(attribute.id()), H5Tclose, place, "damaged type");
}

/// Opens a scalar attribute of the class that is expected; anything else would overrun the reader's memory.
Handle open_scalar(const Node& node, const std::string& name, H5T_class_t expected,
                   const char* expected_name) {
    const std::string place = attribute_place(node, name);
    Handle attribute = open_attribute(node, name);
    const Handle space = own(H5Aget_space(attribute.id()), H5Sclose, place, "damaged extent");
    const Handle type = type_of(attribute, place);
    const bool right_text = expected != H5T_STRING || H5Tis_variable_str(type.id()) > 0;
    if (H5Tget_class(type.id()) != expected || H5Sget_simple_extent_npoints(space.id()) != 1 || !right_text) {
        throw DataError(place + ": expected " + expected_name);
    }
    return attribute;
}

template <typename Number>
Number read_number(const Node& node, const std::string& name, H5T_class_t expected, const char* expected_name,
                   hid_t memory_type) {
    const Handle attribute = open_scalar(node, name, expected, expected_name);
    Number value = 0;
    check(H5Aread(attribute.id(), memory_type, &value), attribute_place(node, name), "damaged attribute");
    return value;
}

Handle array_layout(std::span<const hsize_t> shape, std::size_t values, Packing packing,
                    const std::string& place) {
    const char* message = "cannot describe the array";
    Handle layout = own(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, place, message);
    if (values < compress_from || packing == Packing::plain) return layout;
    const hsize_t row = shape.size() == 2 ? shape[1] : 1;
    const std::array<hsize_t, 2> chunk{std::clamp<hsize_t>(values_per_chunk / row, 1, shape[0]), row};
    check(H5Pset_chunk(layout.id(), static_cast<int>(shape.size()), chunk.data()), place, message);
    check(H5Pset_shuffle(layout.id()), place, message);
    check(H5Pset_deflate(layout.id(), 1), place, message);
    return layout;
}

Node open_dataset(const Node& parent, const std::string& name) {
    const std::string place = parent.place() + "/" + name;
    return {own(H5Dopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Dclose, place,
                "the dataset is missing or damaged"),
            place};
}

std::vector<hsize_t> shape_of(const Handle& space, const std::string& place) {
    const int rank = H5Sget_simple_extent_ndims(space.id());
    if (rank != 1 && rank != 2) throw DataError(place + ": expected one or two dimensions");
    std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
    return shape;
}

}  // namespace

void write_attribute(const Node& node, const std::string& name, double value) {
    write_scalar(node, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

void write_attribute(const Node& node, const std::string& name, std::uint64_t value) {
    write_scalar(node, name, H5T_STD_U64LE, H5T_NATIVE_UINT64, &value);
}

void write_attribute(const Node& node, const std::string& name, const std::string& value) {
    const Handle type = text_type(attribute_place(node, name));
    const char* text = value.c_str();
    write_scalar(node, name, type.id(), type.id(), &text);
}

void attach_scale(const Node& dataset, unsigned dimension, const Node& scale, const std::string& name) {
    const char* message = "cannot mark the coordinates of a dimension";
    if (H5DSis_scale(scale.id()) <= 0) check(H5DSset_scale(scale.id(), name.c_str()), scale.place(), message);
    check(H5DSattach_scale(dataset.id(), scale.id(), dimension), dataset.place(), message);
}

double read_double(const Node& node, const std::string& name) {
    return read_number<double>(node, name, H5T_FLOAT, "one floating-point number", H5T_NATIVE_DOUBLE);
}

std::uint64_t read_unsigned(const Node& node, const std::string& name) {
    return read_number<std::uint64_t>(node, name, H5T_INTEGER, "one integer", H5T_NATIVE_UINT64);
}

std::string read_text(const Node& node, const std::string& name) {
    const std::string place = attribute_place(node, name);
    const Handle attribute = open_scalar(node, name, H5T_STRING, "one text of variable length");
    const Handle type = type_of(attribute, place);
    char* text = nullptr;
    check(H5Aread(attribute.id(), type.id(), &text), place, "damaged attribute");
    const std::string value = text != nullptr ? text : "";  // HDF5 returns the empty text as a null pointer
    H5free_memory(text);
    return value;
}

bool is_text(const Node& node, const std::string& attribute) {
    const Handle opened = open_attribute(node, attribute);
    return H5Tget_class(type_of(opened, attribute_place(node, attribute)).id()) == H5T_STRING;
}

Node write_array(const Node& parent, const std::string& name, std::span<const double> values,
                 std::size_t columns, Packing packing) {
    const std::string place = parent.place() + "/" + name;
    const char* message = "cannot write the array";
    std::vector<hsize_t> shape{values.size()};
    if (columns > 0) shape = {values.size() / columns, columns};
    const Handle space = own(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                             H5Sclose, place, message);
    const Handle layout = array_layout(shape, values.size(), packing, place);
    Node dataset(own(H5Dcreate2(parent.id(), name.c_str(), H5T_IEEE_F64LE, space.id(), H5P_DEFAULT,
                                layout.id(), H5P_DEFAULT),
                     H5Dclose, place, message),
                 place);
    if (!values.empty()) {
        check(H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), place,
              message);
    }
    return dataset;
}

namespace {

/// A damaged extent must not take the machine's memory: deflate packs no denser than 1032 to 1.
void check_claim(const Node& dataset, double values) {
    const char* message = "damaged dataset";
    const Handle file = own(H5Iget_file_id(dataset.id()), H5Fclose, dataset.place(), message);
    hsize_t size = 0;
    check(H5Fget_filesize(file.id(), &size), dataset.place(), message);
    if (values * sizeof(double) > 1032.0 * static_cast<double>(size))
        throw DataError(dataset.place() + ": claims more values than the file can hold");
}

}  // namespace

Array read_array(const Node& parent, const std::string& name) {
    const Node dataset = open_dataset(parent, name);
    const char* message = "damaged dataset";
    const Handle type = own(H5Dget_type(dataset.id()), H5Tclose, dataset.place(), message);
    if (H5Tget_class(type.id()) != H5T_FLOAT) {
        throw DataError(dataset.place() + ": expected floating-point numbers");
    }
    const Handle space = own(H5Dget_space(dataset.id()), H5Sclose, dataset.place(), message);
    Array array;
    array.shape = shape_of(space, dataset.place());
    double claimed = 1;
    for (const hsize_t extent : array.shape) claimed *= static_cast<double>(extent);
    check_claim(dataset, claimed);
    array.values.resize(array.shape.size() == 2 ? array.shape[0] * array.shape[1] : array.shape[0]);
    if (!array.values.empty()) {
        check(H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()),
              dataset.place(), message);
    }
    return array;
}

Node create_table(const Node& file, const std::string& name, std::size_t columns,
                  std::size_t rows_per_chunk) {
    const std::string place = file.place() + " /" + name;
    const char* message = "cannot create the table";
    const std::array<hsize_t, 2> empty{0, columns};
    const std::array<hsize_t, 2> largest{H5S_UNLIMITED, columns};
    const std::array<hsize_t, 2> chunk{rows_per_chunk, columns};
    const Handle space = own(H5Screate_simple(2, empty.data(), largest.data()), H5Sclose, place, message);
    const Handle layout = own(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, place, message);
    check(H5Pset_chunk(layout.id(), 2, chunk.data()), place, message);
    constexpr double unwritten = std::numeric_limits<double>::quiet_NaN();
    check(H5Pset_fill_value(layout.id(), H5T_NATIVE_DOUBLE, &unwritten), place, message);
    return {own(H5Dcreate2(file.id(), name.c_str(), H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, layout.id(),
                           H5P_DEFAULT),
                H5Dclose, place, message),
            place};
}

void append_rows(const Node& table, std::size_t rows, std::size_t columns, std::span<const double> values) {
    const char* message = "cannot add rows";
    const std::array<hsize_t, 2> start{rows, 0};
    const std::array<hsize_t, 2> count{values.size() / columns, columns};
    const std::array<hsize_t, 2> extent{rows + count[0], columns};
    check(H5Dset_extent(table.id(), extent.data()), table.place(), message);
    const Handle file_space = own(H5Dget_space(table.id()), H5Sclose, table.place(), message);
    const Handle memory_space =
        own(H5Screate_simple(2, count.data(), nullptr), H5Sclose, table.place(), message);
    check(H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
          table.place(), message);
    check(H5Dwrite(table.id(), H5T_NATIVE_DOUBLE, memory_space.id(), file_space.id(), H5P_DEFAULT,
                   values.data()),
          table.place(), message);
}

}  // namespace wetdeck::hdf5
