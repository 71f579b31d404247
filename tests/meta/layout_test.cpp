// SPDX-License-Identifier: BSD-3-Clause
// The sources include each other as docs/layout.txt says.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace {

using Arrows = std::map<std::string, std::set<std::string>>;

/// The folder of a path below the root: its first two parts, or the first alone for a file that lies there.
std::string folder_of(const fs::path& path) {
    auto part = path.begin();
    const fs::path top = *part++;
    const fs::path second = *part++;
    return part == path.end() ? top.string() : (top / second).string();
}

/// The arrows between folders that the includes of a source make.
void add_arrows(const std::string& folder, std::istream& source, Arrows& arrows) {
    static const std::regex include("#include \"((solver|validation|reports)/[^\"]+)\".*");
    std::smatch found;
    arrows[folder];
    for (std::string line; std::getline(source, line);) {
        if (!std::regex_match(line, found, include)) continue;
        const std::string other = folder_of(found[1].str());
        if (other != folder) arrows[folder].insert(other);
    }
}

Arrows arrows_of_sources(const fs::path& root) {
    Arrows arrows;
    for (const char* top : {"solver", "validation", "reports"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
            const fs::path extension = entry.path().extension();
            if (extension != ".cpp" && extension != ".hpp") continue;
            std::ifstream source(entry.path());
            add_arrows(folder_of(entry.path().lexically_relative(root)), source, arrows);
        }
    }
    return arrows;
}

Arrows listed_arrows(std::istream& layout) {
    Arrows arrows;
    for (std::string line; std::getline(layout, line);) {
        if (line.empty() || line.front() == '#') continue;
        const std::size_t colon = line.find(':');
        std::istringstream rest(line.substr(colon + 1));
        std::set<std::string>& targets = arrows[line.substr(0, colon)];
        for (std::string target; rest >> target;) targets.insert(target);
    }
    return arrows;
}

/// "a -> b" for each arrow of `some` that `all` lacks.
std::vector<std::string> missing(const Arrows& some, const Arrows& all) {
    std::vector<std::string> result;
    for (const auto& [from, targets] : some) {
        if (!all.contains(from)) result.push_back(from);
        for (const std::string& to : targets)
            if (!all.contains(from) || !all.at(from).contains(to)) result.push_back(from + " -> " + to);
    }
    return result;
}

/// Folders from which a way along the arrows leads back.
std::vector<std::string> in_circles(const Arrows& arrows) {
    std::vector<std::string> result;
    for (const auto& [start, ignored] : arrows) {
        std::set<std::string> reached;
        std::vector<std::string> open = {start};
        while (!open.empty()) {
            const std::string here = open.back();
            open.pop_back();
            if (!arrows.contains(here)) continue;
            for (const std::string& next : arrows.at(here))
                if (reached.insert(next).second) open.push_back(next);
        }
        if (reached.contains(start)) result.push_back(start);
    }
    return result;
}

}  // namespace

TEST_CASE("Folders include each other only as the layout file lists, and never in a circle", "[layout]") {
    const fs::path root = WETDECK_SOURCE_DIR;
    std::ifstream file(root / "docs/layout.txt");
    const Arrows listed = listed_arrows(file), found = arrows_of_sources(root);
    REQUIRE(found.size() > 20);
    CHECK(missing(found, listed) == std::vector<std::string>{});
    CHECK(missing(listed, found) == std::vector<std::string>{});
    CHECK(in_circles(listed) == std::vector<std::string>{});
}

TEST_CASE("The check of the layout sees an arrow that is not listed, and a circle", "[layout]") {
    std::istringstream layout("# words\nsolver/core:\nsolver/time: solver/core\n");
    const Arrows listed = listed_arrows(layout);
    Arrows found = listed;
    std::istringstream source("#include <cmath>\n#include \"solver/time/verlet.hpp\"\n");
    add_arrows("solver/core", source, found);
    CHECK(missing(found, listed) == std::vector<std::string>{"solver/core -> solver/time"});
    CHECK(in_circles(found) == std::vector<std::string>{"solver/core", "solver/time"});
    CHECK(folder_of("solver/simulation.hpp") == "solver");
    CHECK(folder_of("validation/run/run.cpp") == "validation/run");
}
