// The main function of every test program. With FOLDLESS_EXACT_ONLY set in the environment no filter decides a sign:
// all of them take the exact branch, and every test must come out the same.

#include <foldless/predicates/sign_counts.h>

#include <gmock/gmock.h>

#include <cstdlib>

int main(int count, char** arguments) {
    testing::InitGoogleMock(&count, arguments);
    if (std::getenv("FOLDLESS_EXACT_ONLY") != nullptr) {
        foldless::set_filters_enabled(false);
    }
    return RUN_ALL_TESTS();
}
