#include "common/scene/print_audit.h"

#include <catch2/catch.hpp>

#include <iostream>
#include <sstream>

using namespace hipmap;

namespace {

/// What print_audit prints.
std::string printed(const SceneAudit& audit, bool verbose, std::set<std::string>* told = nullptr)
{
    const std::ostringstream text;
    std::streambuf* const old = std::cerr.rdbuf(text.rdbuf());
    Report report(verbose);
    print_audit(report, audit, told);
    std::cerr.rdbuf(old);
    return text.str();
}

} // namespace

TEST_CASE("audit: sentences about many materials become one line", "[scene]")
{
    CHECK(join_by_name({"material 'a' is dark", "no camera", "material 'b' is dark",
                        "material 'c' is odd", "it's Burley's", "'d' is dark", "of 'Bob's' lamp",
                        "of 'x' lamp"}) ==
          std::vector<std::string>{"material 'a' and 'b' is dark", "no camera",
                                   "material 'c' is odd", "it's Burley's", "'d' is dark",
                                   "of 'Bob's' and 'x' lamp"});
    std::vector<std::string> many;
    for (int i = 0; i < 40; ++i)
        many.push_back("material 'm" + std::to_string(i) + "' is clamped");
    CHECK(join_by_name(many) ==
          std::vector<std::string>{"material 'm0', 'm1', 'm2', 'm3', 'm4' and 35 more is clamped"});
}

TEST_CASE("audit: short by default, a line each where all is asked for, once for all frames",
          "[scene]")
{
    const SceneAudit audit = {
        {"3 faces", "camera 'c'"}, {"material 'a' is dark", "material 'b' is dark"}, {"no light"}};
    CHECK(printed(audit, false) == "scene: 3 faces; camera 'c'\n"
                                   "assumed: material 'a' and 'b' is dark\nwarning: no light\n");
    CHECK(printed(audit, true) ==
          "scene: 3 faces\nscene: camera 'c'\nassumed: material 'a' is dark\n"
          "assumed: material 'b' is dark\nwarning: no light\n");
    std::set<std::string> told;
    CHECK(printed(audit, false, &told) == printed(audit, false));
    SceneAudit later = audit;
    later.found[0] = "3 faces at 0.5 s";
    later.warnings.push_back("no floor");
    CHECK(printed(later, false, &told) == "warning: no floor\n");
}
