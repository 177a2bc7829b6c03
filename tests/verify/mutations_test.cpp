// What verify() says of spoilt base meshes and scans, against an oracle that shares no code with it.

#include "../soak.h"
#include "mutations.h"
#include "surface_oracle.h"
#include "violations.h"

#include <foldless/io/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <string>

namespace foldless {
namespace {

using namespace test;
using oracle::Judgement;

/// A thousand mutants in all.
constexpr int mutants_of_each_kind = 80;
/// In continuous integration: enough to see every kind of violation.
constexpr int fewest_of_each_kind = 10;

/// What both say of one kind of mutant.
struct Row {
    int total = 0;
    int certified = 0;
    int ties = 0;                          ///< left out of the comparison
    int defects = 0;                       ///< refused before anything is verified
    std::map<std::string, int> violations; ///< mutants by the first violation in the order of the enumeration
    std::map<std::string, int> reasons;    ///< of the oracle
};

std::string first_violation(const VerifyResult& result) {
    for (std::size_t kind = 0; kind < violation_count; ++kind) {
        if (result.violations[kind] > 0) {
            return std::string(name(static_cast<Violation>(kind)));
        }
    }
    return "certified";
}

std::optional<VerifyResult> verified(const Pair& pair) {
    try {
        VerifyOptions options;
        options.threads = 1;
        return verify(pair.base, pair.scan, options);
    } catch (const RefusedMesh&) {
        return std::nullopt;
    }
}

void compare(const Pair& pair, Row& row, const std::string& what) {
    ++row.total;
    const std::optional<VerifyResult> result = verified(pair);
    if (!result) {
        ++row.defects;
        return;
    }
    const Judgement truth = oracle::judge(pair.base, pair.scan);
    ++row.violations[first_violation(*result)];
    row.certified += result->certified() ? 1 : 0;
    if (truth.kind == Judgement::Kind::tie) {
        ++row.ties;
        return;
    }
    if (truth.kind == Judgement::Kind::refused) {
        ++row.reasons[truth.reason];
    }
    // With another border than its scan a mutant may represent it still, as one with a trimmed border: the oracle knows
    // no such.
    const bool is_judged = truth.reason != "base border" && truth.reason != "scan border";
    const bool represents = truth.kind == Judgement::Kind::represents;
    if (is_judged) {
        EXPECT_EQ(result->certified(), represents)
            << what << ": " << testing::PrintToString(*result) << "; oracle: " << truth.reason;
    }
}

void print(const std::map<std::string, Row>& table) {
    for (const auto& [kind, row] : table) {
        std::cout << std::left << std::setw(26) << kind << std::right << std::setw(5) << row.total
                  << " mutants: " << row.certified << " certified, " << row.defects << " with a defect, " << row.ties
                  << " ties;";
        for (const auto& [violation, count] : row.violations) {
            if (violation != "certified") {
                std::cout << " " << violation << " " << count << ",";
            }
        }
        std::cout << " oracle:";
        for (const auto& [reason, count] : row.reasons) {
            std::cout << " " << reason << " " << count << ",";
        }
        std::cout << "\n";
    }
}

TEST(Mutants, AreJudgedAsByTheOracle) {
    const int of_each_kind = std::max(fewest_of_each_kind, soak(mutants_of_each_kind));
    std::map<std::string, Row> table;
    for (int kind = 0; kind < mutation_count; ++kind) {
        const auto mutation = static_cast<Mutation>(kind);
        Row& row = table[std::string(name(mutation))];
        for (int n = 0; n < of_each_kind; ++n) {
            Random random(static_cast<std::uint64_t>(1000 * n + kind));
            const Pair pair = random_pair(random);
            compare(mutated(pair, mutation, random), row, std::string(name(mutation)) + " " + std::to_string(n));
        }
    }
    print(table);
}

} // namespace
} // namespace foldless
