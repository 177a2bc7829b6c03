#include "temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>

namespace foldless {
namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Outcome {
    int exit_code;
    std::string errors;
};

/// Runs foldless-generate with the arguments; `before` is put in front of it in the shell.
Outcome run(const std::string& arguments, const std::string& before = "") {
    const TemporaryFolder folder;
    const std::string errors = (folder / "errors").string();
    const int status =
        std::system(fmt::format("{} {} {} >/dev/null 2>{}", before, FOLDLESS_GENERATE, arguments, errors).c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(errors)};
}

void expect_one_line_and(int code, const Outcome& outcome) {
    EXPECT_EQ(outcome.exit_code, code) << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_EQ(outcome.errors.rfind("foldless-generate: ", 0), 0U) << outcome.errors;
}

TEST(Generate, HelpIsNoError) {
    const Outcome outcome = run("--help");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.errors, "");
}

TEST(Generate, WrongUsageIsExitCode2) {
    const TemporaryFolder folder;
    const std::string output = " -o " + (folder / "scan.ply").string();
    for (const std::string arguments :
         {"", "sphere", "sphere --faces 100", "dodecahedron --faces 100 -o", "sphere --faces 11 -o",
          "sphere --faces -5 -o", "sphere --faces many -o", "sphere --faces 99999999999 -o",
          "sphere --faces 100 --noise -1 -o", "sphere --faces 100 --noise nan -o", "sphere --faces 100 --seed x -o",
          "sphere --faces 100 --colour -o", "sphere cube --faces 100 -o"}) {
        SCOPED_TRACE(arguments);
        const bool wants_output = arguments.ends_with("-o");
        expect_one_line_and(2, run(wants_output ? arguments.substr(0, arguments.size() - 2) + output : arguments));
    }
    EXPECT_EQ(folder.entries(), 0U);
}

TEST(Generate, SameArgumentsSameBytes) {
    const TemporaryFolder folder;
    const std::string arguments = "genus2 --faces 3000 --noise 0.1 --seed ";
    const std::string first = (folder / "a.ply").string();
    const std::string second = (folder / "b.ply").string();
    EXPECT_EQ(run(arguments + "1 -o " + first).exit_code, 0);
    EXPECT_EQ(run(arguments + "1 -o " + second).exit_code, 0);
    EXPECT_EQ(text_of(first), text_of(second));
    EXPECT_EQ(run(arguments + "2 -o " + second).exit_code, 0);
    EXPECT_NE(text_of(first), text_of(second));
    EXPECT_EQ(folder.entries(), 2U);
}

TEST(Generate, UnwritableOutputIsExitCode5) {
    const TemporaryFolder folder;
    expect_one_line_and(5, run("sphere --faces 100 -o " + (folder / "absent/scan.ply").string()));
    expect_one_line_and(5, run("sphere --faces 100 -o /dev/full"));
    EXPECT_EQ(folder.entries(), 0U);
}

TEST(Generate, AFailedWriteLeavesTheOldFileAndNothingElse) {
    const TemporaryFolder folder;
    const std::string output = (folder / "scan.ply").string();
    std::ofstream(output) << "precious";
    expect_one_line_and(5, run("sphere --faces 1000000 -o " + output, "ulimit -f 1000;")); // of some 38,000 needed
    EXPECT_EQ(text_of(output), "precious");
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(Generate, ASignalLeavesNothingBehind) {
    const TemporaryFolder folder;
    const std::string output = (folder / "scan.ply").string();
    const Outcome outcome =
        run("sphere --faces 200000000 --noise 0.1 -o " + output, "timeout --preserve-status --signal=TERM 0.5");
    EXPECT_EQ(outcome.exit_code, 128 + SIGTERM);
    EXPECT_EQ(folder.entries(), 0U);
}

TEST(Generate, MemoryDoesNotGrowWithTheScan) {
    const TemporaryFolder folder;
    const std::string output = (folder / "scan.ply").string();
    const auto peak_after = [&](const std::string& faces) {
        EXPECT_EQ(run("bumpy-sphere --faces " + faces + " -o " + output).exit_code, 0);
        rusage usage{};
        getrusage(RUSAGE_CHILDREN, &usage);
        return usage.ru_maxrss; // KiB, the greatest of all children so far
    };
    const long small = peak_after("200000"); // already several chunks
    EXPECT_LT(peak_after("4000000"), small + 4096);
    EXPECT_GT(std::filesystem::file_size(output), 70'000'000U);
}

} // namespace
} // namespace foldless
