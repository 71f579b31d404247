// SPDX-License-Identifier: BSD-3-Clause
// VTK's XML formats, written to and read from memory or file; the writing to disk itself is atomic_write's.
#include "validation/store/frame_file.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkVariant.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <fstream>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

/// Notes that VTK reported an error, which it would otherwise print.
class ErrorObserver : public vtkCommand {
  public:
    static ErrorObserver* New() { return new ErrorObserver; }
    void Execute(vtkObject*, unsigned long, void*) override { seen_ = true; }
    bool seen() const { return seen_; }

  private:
    bool seen_ = false;
};

template <typename Array, typename Value>
void add_array(vtkPolyData* data, const char* name, const std::vector<Value>& values) {
    vtkNew<Array> array;
    array->SetName(name);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
        array->SetValue(static_cast<vtkIdType>(i), values[i]);
    }
    data->GetPointData()->AddArray(array);
}

void require_equal_lengths(const FieldFrame& frame) {
    const std::size_t n = frame.x.size();
    for (const auto* values : {&frame.y, &frame.vx, &frame.vy, &frame.pressure, &frame.density}) {
        if (values->size() != n) throw DataError("field frame: its vectors differ in length");
    }
    const bool spacings_fit = frame.spacing.empty() || frame.spacing.size() == n;
    if (frame.phase.size() != n || frame.id.size() != n || !spacings_fit) {
        throw DataError("field frame: its vectors differ in length");
    }
}

void add_geometry(vtkPolyData* data, const FieldFrame& frame) {
    const auto count = static_cast<vtkIdType>(frame.x.size());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    points->SetNumberOfPoints(count);
    vtkNew<vtkCellArray> vertices;
    vertices->Use32BitStorage();  // half the bytes; the writer's SetIdTypeToInt32 leaves cells as they are
    vtkNew<vtkFloatArray> velocity;
    velocity->SetName("velocity");
    velocity->SetNumberOfComponents(3);
    velocity->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        points->SetPoint(i, frame.x[k], frame.y[k], 0.0);
        velocity->SetTuple3(i, frame.vx[k], frame.vy[k], 0.0);
        vertices->InsertNextCell(1, &i);
    }
    data->SetPoints(points);
    data->SetVerts(vertices);
    data->GetPointData()->AddArray(velocity);
}

/// An array by name with the number of components that is expected, or DataError.
vtkDataArray* require_array(vtkPolyData* data, const char* name, int components,
                            const std::filesystem::path& path) {
    vtkDataArray* array = data->GetPointData()->GetArray(name);
    if (array == nullptr || array->GetNumberOfComponents() != components ||
        array->GetNumberOfTuples() != data->GetNumberOfPoints()) {
        throw DataError(fmt::format("{}: lacks the point array {}", path.string(), name));
    }
    return array;
}

std::vector<float> read_floats(vtkPolyData* data, const char* name, const std::filesystem::path& path) {
    vtkDataArray* array = require_array(data, name, 1, path);
    std::vector<float> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(array->GetTuple1(static_cast<vtkIdType>(i)));
    return values;
}

/// Integers bypass GetTuple1: a double does not hold every 64-bit number.
template <typename Value>
std::vector<Value> read_integers(vtkPolyData* data, const char* name, const std::filesystem::path& path) {
    vtkDataArray* array = require_array(data, name, 1, path);
    // VTK reads "Int64" as long or long long, as it likes.
    const int type = array->GetDataType();
    const bool floating = type == VTK_FLOAT || type == VTK_DOUBLE;
    if (floating || array->GetDataTypeSize() != int{sizeof(Value)} || array->GetDataTypeMin() >= 0) {
        throw DataError(fmt::format("{}: the point array {} has another type", path.string(), name));
    }
    const auto* values = static_cast<const Value*>(array->GetVoidPointer(0));
    return {values, values + array->GetNumberOfTuples()};
}

void read_points(vtkPolyData* data, FieldFrame& frame, const std::filesystem::path& path) {
    vtkDataArray* velocity = require_array(data, "velocity", 3, path);
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
        frame.x.push_back(static_cast<float>(data->GetPoint(i)[0]));
        frame.y.push_back(static_cast<float>(data->GetPoint(i)[1]));
        frame.vx.push_back(static_cast<float>(velocity->GetComponent(i, 0)));
        frame.vy.push_back(static_cast<float>(velocity->GetComponent(i, 1)));
    }
}

}  // namespace

std::string vtp_bytes(const FieldFrame& frame) {
    require_equal_lengths(frame);
    vtkNew<vtkPolyData> data;
    add_geometry(data, frame);
    add_array<vtkFloatArray>(data, "pressure", frame.pressure);
    add_array<vtkFloatArray>(data, "density", frame.density);
    if (!frame.spacing.empty()) add_array<vtkFloatArray>(data, "spacing", frame.spacing);
    add_array<vtkIntArray>(data, "phase", frame.phase);
    add_array<vtkTypeInt64Array>(data, "id", frame.id);
    data->GetPointData()->SetActiveScalars("pressure");  // the array by which ParaView colours at first
    vtkNew<vtkDoubleArray> time;
    time->SetName("TimeValue");
    time->InsertNextValue(frame.time);
    data->GetFieldData()->AddArray(time);
    if (!frame.provenance.empty()) {
        vtkNew<vtkStringArray> provenance;
        provenance->SetName("Provenance");
        provenance->InsertNextValue(frame.provenance);
        data->GetFieldData()->AddArray(provenance);
    }

    vtkNew<vtkXMLPolyDataWriter> writer;
    vtkNew<ErrorObserver> errors;
    writer->AddObserver(vtkCommand::ErrorEvent, errors);
    writer->SetInputData(data);
    writer->SetDataModeToBinary();
    writer->SetCompressorTypeToZLib();
    writer->SetCompressionLevel(1);
    writer->SetHeaderTypeToUInt64();
    writer->WriteToOutputStringOn();
    if (writer->Write() == 0 || errors->seen()) {
        throw EnvironmentError("field frame: VTK cannot write it, error code " +
                               std::to_string(writer->GetErrorCode()));
    }
    return writer->GetOutputString();
}

FieldFrame read_frame(const std::filesystem::path& path) {
    vtkNew<ErrorObserver> errors;
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->AddObserver(vtkCommand::ErrorEvent, errors);
    reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    reader->SetReaderErrorObserver(errors);
    reader->SetParserErrorObserver(errors);
    reader->SetFileName(path.c_str());
    if (reader->CanReadFile(path.c_str()) == 0) {
        throw DataError(path.string() + ": missing or not a VTK PolyData file");
    }
    reader->Update();
    vtkPolyData* data = reader->GetOutput();
    if (errors->seen() || data == nullptr) throw DataError(path.string() + ": damaged VTK file");
    vtkDataArray* time = data->GetFieldData()->GetArray("TimeValue");
    if (time == nullptr || time->GetNumberOfValues() != 1) {
        throw DataError(path.string() + ": lacks the field value TimeValue");
    }
    FieldFrame frame;
    frame.time = time->GetTuple1(0);
    vtkAbstractArray* provenance = data->GetFieldData()->GetAbstractArray("Provenance");
    if (provenance != nullptr && provenance->GetNumberOfValues() == 1)
        frame.provenance = provenance->GetVariantValue(0).ToString();
    read_points(data, frame, path);
    frame.pressure = read_floats(data, "pressure", path);
    frame.density = read_floats(data, "density", path);
    if (data->GetPointData()->HasArray("spacing") != 0) frame.spacing = read_floats(data, "spacing", path);
    frame.phase = read_integers<int>(data, "phase", path);
    frame.id = read_integers<std::int64_t>(data, "id", path);
    return frame;
}

std::string pvd_bytes(const std::vector<FrameEntry>& frames) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n  <Collection>\n";
    for (const FrameEntry& frame : frames) {
        // {} prints the shortest text that reads back as the same number.
        text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", frame.time,
                            frame.path.generic_string());
    }
    return text + "  </Collection>\n</VTKFile>\n";
}

std::vector<FrameEntry> read_pvd(const std::filesystem::path& path) {
    std::ifstream file(path);
    vtkNew<ErrorObserver> errors;
    vtkNew<vtkXMLDataParser> parser;
    parser->AddObserver(vtkCommand::ErrorEvent, errors);
    parser->SetStream(&file);
    const bool parsed = file && parser->Parse() != 0 && !errors->seen();
    vtkXMLDataElement* root = parsed ? parser->GetRootElement() : nullptr;
    vtkXMLDataElement* collection = root != nullptr ? root->FindNestedElementWithName("Collection") : nullptr;
    if (collection == nullptr) throw DataError(path.string() + ": not a whole VTK collection");
    std::vector<FrameEntry> frames;
    for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* entry = collection->GetNestedElement(i);
        const char* name = entry->GetAttribute("file");
        const char* time = entry->GetAttribute("timestep");
        if (name == nullptr || time == nullptr) {
            throw DataError(path.string() + ": a frame lacks its file or timestep");
        }
        frames.push_back({std::strtod(time, nullptr), name});
    }
    return frames;
}

}  // namespace wetdeck
