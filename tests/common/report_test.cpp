#include "common/report.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace hipmap {

using Catch::Matchers::Matches;

namespace {

/// What is written to standard error while this lives.
class CapturedErrors {
  public:
    CapturedErrors() : old_(std::cerr.rdbuf(text_.rdbuf())) {}
    ~CapturedErrors() { std::cerr.rdbuf(old_); }
    CapturedErrors(const CapturedErrors&) = delete;
    CapturedErrors& operator=(const CapturedErrors&) = delete;

    std::string text() const { return text_.str(); }

  private:
    std::ostringstream text_;
    std::streambuf* old_;
};

} // namespace

TEST_CASE("report: warnings are marked and counted, plain lines are not", "[report]")
{
    const CapturedErrors errors;
    Report report;
    report.line("3 faces");
    report.warn("no light");
    report.warn("no camera");
    CHECK(report.warnings() == 2);
    CHECK(errors.text() == "3 faces\nwarning: no light\nwarning: no camera\n");
}

TEST_CASE("report: a finished stage is one line with its seconds", "[report]")
{
    const CapturedErrors errors;
    Report report;
    report.begin("build maps");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const double seconds = report.end();
    CHECK(seconds >= 0.02);
    CHECK(seconds < 60);
    CHECK_THAT(errors.text(), Matches("build maps: [0-9]+\\.[0-9][0-9] s\n"));
}

TEST_CASE("report: progress called often, with any number, prints next to nothing", "[report]")
{
    const CapturedErrors errors;
    Report report;
    report.begin("render");
    for (int i = 0; i < 10'000; ++i)
        report.progress(i / 10'000.0);
    report.progress(std::numeric_limits<double>::quiet_NaN());
    report.progress(-1);
    report.progress(2);
    report.end();
    CHECK(errors.text().size() < 1'000);
}

TEST_CASE("report: a share has the time left, what is not known is not told", "[report]")
{
    CHECK(progress_text("render", 0.25, "5 passes", 18) == "render: 25 %, 5 passes, 18 s left");
    CHECK(progress_text("render", 0.0, "", {}) == "render: 0 %");
    CHECK(progress_text("render", std::nan(""), "", {}) == "render: 0 %");
    CHECK(progress_text("render", 2.0, "", 0.0) == "render: 100 %, 0 s left");
    CHECK(progress_text("render", std::nullopt, "5 passes", {}) == "render: 5 passes");
    CHECK(progress_text("render", std::nullopt, "", 60) == "render: 60 s left");
}

TEST_CASE("report: times and numbers are short and never in exponents", "[report]")
{
    const std::vector<std::pair<double, std::string>> times = {
        {0, "0 s"},       {0.034, "0.034 s"},  {3.44, "3.4 s"},   {9.96, "10 s"},
        {99.4, "99 s"},   {99.6, "2 min"},     {3600, "60 min"},  {9000, "2.5 h"},
        {86'400, "24 h"}, {200'000, "2 days"}, {1e8, "1157 days"}};
    for (const auto& [seconds, text] : times)
        CHECK(brief_time(seconds) == text);
    CHECK(grouped(0) == "0");
    CHECK(grouped(999) == "999");
    CHECK(grouped(1000) == "1,000");
    CHECK(grouped(1'600'000) == "1,600,000");
}

TEST_CASE("report: details are printed where that was asked for", "[report]")
{
    const CapturedErrors errors;
    Report brief, verbose(true);
    brief.detail("small");
    verbose.detail("large");
    CHECK(errors.text() == "large\n");
}

TEST_CASE("report: files written are one line", "[report]")
{
    const CapturedErrors errors;
    Report report;
    report.list_files();
    report.wrote("a.png", "exposure +1 EV");
    report.wrote("a.exr");
    report.list_files();
    report.list_files();
    CHECK(errors.text() == "wrote a.png (exposure +1 EV), a.exr\n");
}

TEST_CASE("report: lines of several threads are not mixed", "[report]")
{
    const CapturedErrors errors;
    Report report;
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&report] {
            for (int j = 0; j < 100; ++j)
                report.line("one line of text");
        });
    for (std::thread& thread : threads)
        thread.join();
    std::string expected;
    for (int i = 0; i < 400; ++i)
        expected += "one line of text\n";
    CHECK(errors.text() == expected);
}

} // namespace hipmap
