// SPDX-License-Identifier: BSD-3-Clause
// Places where nothing can be written: below a regular file, without permission, on a read-only file system.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "solver/core/errors.hpp"
#include "tests/faults/fault_support.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/fields.hpp"
#include "validation/store/live_series.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

using namespace wetdeck;
using samples::ScratchFolder;

namespace {

using std::filesystem::perms;
constexpr perms read_and_enter =
    perms::owner_read | perms::owner_exec | perms::others_read | perms::others_exec;

/// Permissions do not bind root: while this lives, root acts as "nobody".
class OrdinaryUser {
  public:
    OrdinaryUser() {
        constexpr uid_t nobody = 65534;
        if (was_root_ && ::seteuid(nobody) != 0) WARN("not tested: root cannot act as another user here");
    }
    ~OrdinaryUser() {
        if (was_root_ && ::seteuid(0) != 0) std::abort();
    }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;

    bool binds() const { return ::geteuid() != 0; }

  private:
    bool was_root_ = ::geteuid() == 0;
};

/// What `action` says when the machine refuses; fails the test if it does not throw EnvironmentError.
template <typename Action>
std::string refusal(const Action& action) {
    try {
        action();
    } catch (const EnvironmentError& error) {
        return error.what();
    }
    FAIL("expected an EnvironmentError");
    return {};
}

/// Every writer refuses `directory` with a message that names it and holds `reason`.
void expect_refusals(const std::filesystem::path& directory, const std::string& reason) {
    for (const std::string& message :
         {refusal([&] { RunDirectory(directory, "identity"); }),
          refusal([&] { write_run(directory, samples::record(3)); }), refusal([&] {
              LiveSeries(directory, {{"a", "m", ""}});
          }),
          refusal([&] { FieldWriter{directory}; })}) {
        REQUIRE_THAT(message, Catch::Contains(directory.string()) && Catch::Contains(reason));
    }
}

}  // namespace

TEST_CASE("a run directory below a regular file is refused", "[faults]") {
    const ScratchFolder folder;
    samples::put_bytes(folder / "file", "x");
    expect_refusals(folder / "file/run", "Not a directory");
}

TEST_CASE("a regular file is refused as a run directory", "[faults]") {
    const ScratchFolder folder;
    samples::put_bytes(folder / "file", "x");
    REQUIRE_THROWS_AS(RunDirectory(folder / "file", "identity"), EnvironmentError);
    REQUIRE_THROWS_WITH(RunDirectory(folder / "file", "identity"), Catch::Contains("Not a directory"));
    REQUIRE(samples::bytes_of(folder / "file") == "x");
}

TEST_CASE("a directory without permission is refused", "[faults]") {
    const ScratchFolder folder;
    std::filesystem::permissions(folder, read_and_enter);
    {
        const OrdinaryUser user;
        if (user.binds()) expect_refusals(folder, "Permission denied");
    }
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
}

TEST_CASE("a read-only file system is refused", "[faults]") {
    const samples::SmallFileSystem disk("size=64k", MS_RDONLY);
    if (!disk.error().empty()) {
        WARN("not tested: no file system can be mounted here: " << disk.error());
        return;
    }
    expect_refusals(disk.path(), "Read-only file system");
}

TEST_CASE("a run file without permission to read is refused as such", "[faults]") {
    const ScratchFolder folder;
    write_run(folder, samples::record(3));
    std::filesystem::permissions(run_file(folder), std::filesystem::perms::none);
    std::filesystem::permissions(folder, read_and_enter);
    {
        const OrdinaryUser user;
        if (user.binds()) {
            REQUIRE_THAT(refusal([&] { read_run(run_file(folder)); }),
                         Catch::Contains("run.h5: ") && Catch::Contains("Permission denied"));
        }
    }
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
}
