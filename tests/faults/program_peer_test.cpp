// SPDX-License-Identifier: BSD-3-Clause
// `peer` is killed in the middle of a mesh. A script stands in for the solver: it writes the forces and the
// probes that the case asks for, the force as a line over time.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/faults/program_support.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::bytes_of;
using samples::Program;
using samples::run_program;
using samples::ScratchFolder;
using std::chrono::seconds;
namespace fs = std::filesystem;

namespace {

/// interFoam for a while: a script of this name is the first one on the PATH. HOME/started has one line for
/// each case; where HOME/stop is there, the second mesh stays half written.
class StandIn {
  public:
    StandIn() : path_(std::getenv("PATH")) {
        const fs::path script = folder_ / "interFoam";
        samples::put_bytes(script, "#!/bin/sh\nhome='" + (folder_ / "").string() + "'\n" + body);
        fs::permissions(script, fs::perms::owner_all);
        ::setenv("PATH", (fs::path(folder_).string() + ":" + path_).c_str(), 1);
    }
    ~StandIn() { ::setenv("PATH", path_.c_str(), 1); }
    StandIn(const StandIn&) = delete;
    StandIn& operator=(const StandIn&) = delete;

    fs::path file(const std::string& name) const { return folder_ / name; }
    /// How often a case was started.
    int starts_of(const std::string& cell) const {
        std::istringstream lines(bytes_of(file("started")));
        int count = 0;
        for (std::string line; std::getline(lines, line);) count += line.ends_with("/" + cell) ? 1 : 0;
        return count;
    }

  private:
    static constexpr const char* body = R"sh(
echo "$PWD" >> "$home/started"
mkdir -p 1
printf 'internalField uniform (1.5 0 0);\nboundaryField\n' > 1/U
rows() { # FROM TO, of 200
    awk -v from="$1" -v to="$2" '
        $1 == "endTime" { end = $2 + 0 }
        /^    [a-z_0-9]+$/ { name = $1; count = 0 }
        /type forces/ { of[name] = "forces" }
        /type probes/ { field = $0; sub(/.*fields \(/, "", field); sub(/\).*/, "", field); of[name] = field }
        /^            \(/ { place[name, count++] = $0; points[name] = count }
        END {
            for (name in of) {
                folder = "postProcessing/" name "/0"
                system("mkdir -p " folder)
                if (of[name] == "forces") {
                    for (k = from; k < to; ++k) {
                        t = end * k / 200
                        force = sprintf("(0 %.9g 0)", 1e6 * t)
                        line = sprintf("%.9g %s %s (0 0 0)", t, force, force)
                        print line >> (folder "/force.dat")
                        print line >> (folder "/moment.dat")
                    }
                    continue
                }
                file = folder "/" of[name]
                if (from == 1) for (i = 0; i < points[name]; ++i) print "# Probe " i " " place[name, i] >> file
                for (k = from; k < to; ++k) {
                    line = end * k / 200
                    for (i = 0; i < points[name]; ++i) line = line " 0.5"
                    print line >> file
                }
            }
        }' system/controlDict
}
rows 1 100
echo
echo "Time = 0.001"
if [ -e "$home/stop" ] && [ "$(grep -c /cell "$home/started")" = 2 ]; then
    touch "$home/half"
    exec sleep 100
fi
rows 100 201
)sh";

    std::string path_;
    ScratchFolder folder_;
};

}  // namespace

TEST_CASE("peer that is killed within a mesh takes its solver along, and goes on with the meshes it has",
          "[faults]") {
    const StandIn solver;
    const ScratchFolder folder;
    const std::string out = folder / "peer";
    const std::vector<std::string> command{"peer", "openfoam", "wedge",   "--variant", "constant-velocity",
                                           "--dx", "0.03",     "--cells", "1,1.2,1.5", "--out",
                                           out};
    samples::put_bytes(solver.file("stop"), "");
    {
        Program program(command, folder);
        REQUIRE(Program::true_within(seconds(60), [&] { return fs::exists(solver.file("half")); }));
        program.kill_parent();
        CHECK(program.all_gone_within(seconds(10)));
    }
    // what is half written is there, and is no result
    CHECK(fs::exists(out + "/cell0.03/finished"));
    CHECK(fs::exists(out + "/cell0.025/postProcessing/body/0/force.dat"));
    CHECK_FALSE(fs::exists(out + "/cell0.025/finished"));
    CHECK_FALSE(fs::exists(out + "/peer.json"));
    CHECK_FALSE(fs::exists(out + "/curves"));

    fs::remove(solver.file("stop"));
    const auto again = run_program(command);
    INFO(again.err);
    REQUIRE(again.code == 0);
    CHECK(solver.starts_of("cell0.03") == 1);
    CHECK(solver.starts_of("cell0.025") == 2);
    CHECK(solver.starts_of("cell0.02") == 1);
    const auto result = nlohmann::json::parse(bytes_of(out + "/peer.json"));
    bool found = false;
    for (const auto& quantity : result.at("quantities")) {
        if (quantity.at("values").at("qoi") != "force_coefficient") continue;
        found = true;
        const auto values = quantity.at("values").at("value").get<std::vector<double>>();
        REQUIRE(values.size() == 3);
        CHECK(values[0] == values[1]);  // a line through the first half alone would be another one
        CHECK(values[1] == Approx(values[2]));
    }
    CHECK(found);
    // and once more: nothing is left to run
    CHECK(run_program(command).code == 0);
    CHECK(solver.starts_of("cell0.025") == 2);
}

TEST_CASE("a second peer in the same directory is refused while the first one works", "[faults]") {
    const StandIn solver;
    const ScratchFolder folder;
    const std::string out = folder / "peer";
    const std::vector<std::string> command{"peer", "openfoam", "wedge", "--variant", "constant-velocity",
                                           "--dx", "0.03",     "--out", out,         "--cells",
                                           "1,1.2"};
    samples::put_bytes(solver.file("stop"), "");
    const Program first(command, folder);
    REQUIRE(Program::true_within(seconds(60), [&] { return fs::exists(solver.file("half")); }));
    const auto second = run_program(command);
    CHECK(second.code == 4);
    CHECK(second.one_line());
    CHECK_THAT(second.err, Contains("another process is working in this directory"));
    CHECK(solver.starts_of("cell0.025") == 1);
}
