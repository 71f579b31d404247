// SPDX-License-Identifier: BSD-3-Clause
// Comparison metrics of series with a known relation to their reference.
#include "validation/metrics/compare.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "solver/core/errors.hpp"

using namespace wetdeck;

namespace {

/// A folder with the reference y = 2 exp(-(x-5)^2), x = 0 to 10, as bump.csv, and others.
class Folder {
  public:
    Folder() {
        std::filesystem::create_directories(path);
        std::ofstream bump(path / "bump.csv");
        bump.precision(17);
        bump << header << "T [-],y [-],t [s],p [Pa],gap [-]\n";
        for (int i = 0; i <= 1000; ++i) {
            const double x = 0.01 * i;
            const double y = 2 * std::exp(-(x - 5) * (x - 5));
            bump << x << ',' << y << ',' << 0.25 * x << ',' << 100 * y << ',' << (i % 100 == 50 ? "" : "1")
                 << '\n';
        }
        std::ofstream(path / "flat.csv") << header << "T [-],y [-]\n0,1\n10,1\n";
        std::ofstream(path / "ramp.csv") << header << "T [-],y [-]\n0,0\n10,1\n";
        std::ofstream(path / "broken.csv") << header << "T [-],y [-]\n0,oops\n";
    }
    ~Folder() { std::filesystem::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("wetdeck_compare_" + std::to_string(getpid()));

  private:
    static constexpr const char* header =
        "# kind: analytic\n# citation: A bump\n# doi: none\n# figure: none\n# obtained: computed\n# "
        "obtained_from: formula\n"
        "# date: 2026-01-31\n# digitisation_error: none\n# u_data: 0.02\n# u_data_source: made up\n# sensor: "
        "none\n"
        "# filter: none\n# sign: up\n# time_origin: none\n# note: none\n";
};

template <typename Function>
RunRecord run_with(Function f, double end = 10) {
    RunRecord record;
    Series series;
    for (int i = 0; i <= 5000; ++i) {
        series.time.push_back(end * i / 5000);
        series.value.push_back(f(series.time.back()));
    }
    record.series["y"] = std::move(series);
    return record;
}

double bump(double x) {
    return 2 * std::exp(-(x - 5) * (x - 5));
}

ComparisonSpec spec_of(const std::string& reference) {
    ComparisonSpec spec;
    spec.quantity = "y";
    spec.reference = reference;
    spec.x_column = "T";
    spec.y_column = "y";
    spec.window = Window{1, 9};
    spec.tolerance = 0.01;
    return spec;
}

ComparisonResult result_of(const ComparisonSpec& spec, const RunRecord& record) {
    const Folder folder;
    ReferenceShelf shelf(folder.path);
    return compare(spec, record, shelf);
}

}  // namespace

TEST_CASE("A series on its reference is within tolerance and carries the reference's facts", "[compare]") {
    const ComparisonResult result = result_of(spec_of("bump"), run_with(bump));
    CHECK(result.nrmse.value() < 1e-4);
    CHECK(result.peak_error.value() == Approx(0).margin(1e-4));
    CHECK(result.time_error.value() == Approx(0).margin(0.005));
    CHECK(result.within);
    CHECK(result.available);
    CHECK(result.kind == ReferenceKind::analytic);
    CHECK(result.citation == "A bump");
    CHECK(result.reference_uncertainty == StandardUncertainty{0.02});
    CHECK(result.note.empty());
}

TEST_CASE("A raised series has its offset over the range of the reference as error", "[compare]") {
    const ComparisonResult result =
        result_of(spec_of("bump"), run_with([](double x) { return bump(x) + 0.1; }));
    CHECK(result.nrmse.value() == Approx(0.1 / 2).epsilon(1e-3));
    CHECK(result.peak_error.value() == Approx(0.1 / 2).epsilon(1e-3));
    CHECK_FALSE(result.within);
}

TEST_CASE("A late series shows its delay as time error and no peak error", "[compare]") {
    const ComparisonResult result =
        result_of(spec_of("bump"), run_with([](double x) { return bump(x - 0.3); }));
    CHECK(result.time_error.value() == Approx(0.3).margin(0.005));
    CHECK(result.peak_error.value() == Approx(0).margin(1e-4));
    CHECK_FALSE(result.within);
}

TEST_CASE("Scales and offset of the comparison apply to the series", "[compare]") {
    ComparisonSpec spec = spec_of("bump");
    spec.x_scale = 0.25;
    spec.y_scale = 100;
    spec.y_offset = 2;
    const auto in_si = run_with([](double t) { return 100 * (bump(t / 0.25) + 2); }, 2.5);
    CHECK(result_of(spec, in_si).nrmse.value() < 1e-4);
}

TEST_CASE("A reference in SI units is scaled like the series", "[compare]") {
    ComparisonSpec spec = spec_of("bump");
    spec.x_scale = 0.25;
    spec.y_scale = 100;
    spec.x_column = "t";
    spec.y_column = "p";
    const auto in_si = run_with([](double t) { return 100 * bump(t / 0.25); }, 2.5);
    CHECK(result_of(spec, in_si).nrmse.value() < 1e-4);
}

TEST_CASE("A front has no peak to time", "[compare]") {
    const ComparisonResult result = result_of(spec_of("ramp"), run_with([](double x) { return 0.1 * x; }));
    CHECK(result.nrmse.value() == Approx(0).margin(1e-12));
    CHECK_FALSE(result.time_error.has_value());
}

TEST_CASE("Aligned peaks leave amplitude and shape as difference, and no error of time", "[compare]") {
    ComparisonSpec spec = spec_of("bump");
    spec.align_peaks = true;
    spec.window = Window{-3, 3};
    const ComparisonResult late = result_of(spec, run_with([](double x) { return bump(x - 1.2); }));
    CHECK(late.nrmse.value() < 1e-3);
    CHECK(late.peak_error.value() == Approx(0).margin(1e-4));
    CHECK_FALSE(late.time_error.has_value());
    CHECK(late.note == "aligned on the peaks, 6.2 of the series and 5 of the reference on their own axes");
    CHECK(late.simulated.x.front() == Approx(-6.2));
    CHECK(late.measured.x.front() == Approx(-5));
    const ComparisonResult high = result_of(spec, run_with([](double x) { return 1.5 * bump(x + 0.4); }));
    CHECK(high.peak_error.value() == Approx(0.5).epsilon(1e-3));
}

TEST_CASE("A curve without a peak inside is not aligned", "[compare]") {
    ComparisonSpec spec = spec_of(GENERATE("bump", "ramp"));
    spec.align_peaks = true;
    spec.window = Window{-3, 3};
    const bool ramp = spec.reference == "ramp";
    const ComparisonResult result = result_of(spec, run_with(ramp ? bump : +[](double x) { return x; }));
    CHECK_FALSE(result.nrmse.has_value());
    CHECK_FALSE(result.within);
    CHECK(result.note == (ramp ? "the reference has its largest value at an end, there is no peak to align"
                               : "series 'y' has its largest value at an end, there is no peak to align"));
    CHECK((ramp ? result.measured : result.simulated).x.empty());
}

TEST_CASE("A missing reference file is neither a success nor a failure", "[compare]") {
    const ComparisonResult result = result_of(spec_of("nobody2000"), run_with(bump));
    CHECK_FALSE(result.available);
    CHECK_FALSE(result.nrmse.has_value());
    CHECK(result.note == "curve not available: no file nobody2000.csv");
    CHECK(result.simulated.x.size() == 5001);
}

TEST_CASE("A faulty reference file leaves out its comparison and says why", "[compare]") {
    const ComparisonResult faulty = result_of(spec_of("broken"), run_with(bump));
    CHECK_FALSE(faulty.available);
    CHECK(faulty.unusable);
    CHECK_FALSE(faulty.nrmse.has_value());
    CHECK_FALSE(faulty.kind.has_value());
    CHECK_THAT(faulty.note, Catch::StartsWith("curve not available: ") &&
                                Catch::Contains("broken.csv:17: y is 'oops', expected a number"));
    ComparisonSpec spec = spec_of("bump");
    spec.y_column = "z";
    const ComparisonResult lacking = result_of(spec, run_with(bump));
    CHECK(lacking.unusable);
    CHECK_THAT(lacking.note, Catch::Contains("bump.csv: no column 'z', there are T, y"));
    CHECK_FALSE(result_of(spec_of("nobody2000"), run_with(bump)).unusable);
}

TEST_CASE("Empty cells of the reference are left out and counted in the note", "[compare]") {
    ComparisonSpec spec = spec_of("bump");
    spec.y_column = "gap";
    const ComparisonResult result = result_of(spec, run_with(bump));
    CHECK_THAT(result.note, Catch::StartsWith("10 empty cells of column 'gap' left out"));
}

TEST_CASE("A constant reference has nothing to normalise with", "[compare]") {
    const ComparisonResult result = result_of(spec_of("flat"), run_with([](double) { return 1.0; }));
    CHECK_FALSE(result.nrmse.has_value());
    CHECK_FALSE(result.within);
    CHECK_THAT(result.note, Catch::Contains("constant"));
}

TEST_CASE("A reference that is only shown has its curve and neither metrics nor a verdict", "[compare]") {
    ComparisonSpec spec = spec_of("bump");
    spec.judged = false;
    const ComparisonResult result = result_of(spec, run_with(bump));
    CHECK(result.available);
    CHECK_FALSE(result.judged);
    CHECK_FALSE(result.measured.x.empty());
    CHECK_FALSE(result.simulated.x.empty());
    CHECK_FALSE(result.nrmse.has_value());
    CHECK(result.note == "shown, not judged");
}

TEST_CASE("Without a window the whole overlap is compared", "[compare]") {
    ComparisonSpec spec = spec_of("bump");
    spec.window.reset();
    CHECK(result_of(spec, run_with(bump, 7)).within);
}

TEST_CASE("A window beyond the reference is compared where the reference reaches, with a note", "[compare]") {
    ComparisonSpec spec = spec_of("bump");
    spec.window = Window{1, 12};
    const ComparisonResult result = result_of(spec, run_with(bump, 12));
    CHECK(result.within);
    CHECK(result.note == "the reference spans 0 to 10, the window is 1 to 12");
    spec.window = Window{11, 12};
    CHECK_FALSE(result_of(spec, run_with(bump, 12)).within);
}
