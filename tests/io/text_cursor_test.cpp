#include <foldless/io/text_cursor.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foldless {
namespace {

using Lines = std::vector<std::vector<std::string>>;

constexpr TextCursor::Options all_options{.comments = true, .continuations = true};

Lines lines_of(std::string_view text, const TextCursor::Options& options = all_options) {
    TextCursor cursor(text, "f", options);
    Lines lines;
    while (cursor.next_line()) {
        lines.emplace_back();
        for (std::string_view token = cursor.token(); !token.empty(); token = cursor.token()) {
            lines.back().emplace_back(token);
        }
    }
    return lines;
}

TEST(TextCursor, EndsLinesAtEveryKindOfLineEnd) {
    const Lines expected{{"a", "b"}, {"c"}};
    for (const char* text : {"a b\nc", "a b\r\nc\r\n", "a b\rc\r", "\n\na\t b \n\n \nc\n",
                             "\xef\xbb\xbf"
                             "a b\nc"}) {
        EXPECT_EQ(lines_of(text), expected) << text;
    }
}

TEST(TextCursor, HasNoLinesInBlankText) {
    for (const char* text : {"", "\n", " \t\r\n\n", "# only this", "\xef\xbb\xbf"}) {
        EXPECT_EQ(lines_of(text), Lines{}) << text;
    }
}

TEST(TextCursor, SkipsCommentsOnlyWhereTheyExist) {
    EXPECT_EQ(lines_of("# x\na #b\nc#d e\n"), (Lines{{"a"}, {"c"}}));
    EXPECT_EQ(lines_of("a #b\n", {}), (Lines{{"a", "#b"}}));
}

TEST(TextCursor, JoinsContinuedLines) {
    EXPECT_EQ(lines_of("a \\\nb\\\r\nc\nd"), (Lines{{"a", "b", "c"}, {"d"}}));
    EXPECT_EQ(lines_of("# a \\\nb\n"), (Lines{{"b"}}));
    EXPECT_EQ(lines_of("a\\\nb", {}), (Lines{{"a\\"}, {"b"}}));
}

TEST(TextCursor, SkipsWhatIsLeftOfALineAndItsContinuation) {
    TextCursor cursor("a b \\\nc\nd", "f", all_options);
    ASSERT_TRUE(cursor.next_line());
    EXPECT_EQ(cursor.token(), "a");
    ASSERT_TRUE(cursor.next_line());
    EXPECT_EQ(cursor.token(), "d");
}

TEST(TextCursor, TellsTheRestOfALineWithoutTakingIt) {
    struct Rest {
        const char* line;
        const char* rest;
    };
    const Rest cases[] = {{"k  a b\t\r\nc", "a b"},     {"k", ""},      {"k \t", ""},
                          {"k a#1.png # b", "a#1.png"}, {"k # a", ""},  {"k#a", ""},
                          {"k a \\\nb", "a \\"},        {"k a\rb", "a"}};
    for (const auto& [line, rest] : cases) {
        TextCursor cursor(line, "f", all_options);
        ASSERT_TRUE(cursor.next_line());
        EXPECT_EQ(cursor.token(), "k");
        EXPECT_EQ(cursor.rest_of_line(), rest) << line;
        EXPECT_EQ(cursor.rest_of_line(), rest) << line;
    }
    TextCursor without_comments("k # a\n", "f", {});
    ASSERT_TRUE(without_comments.next_line());
    EXPECT_EQ(without_comments.token(), "k");
    EXPECT_EQ(without_comments.rest_of_line(), "# a");
}

TEST(TextCursor, NamesFileLineAndReason) {
    const auto fail = [](std::string_view text) {
        return message_of<UnreadableFile>([&] {
            TextCursor cursor(text, "f", {});
            while (cursor.next_line()) {
                static_cast<void>(cursor.real("x"));
                static_cast<void>(cursor.integer("n"));
                cursor.require_end_of_line();
            }
        });
    };
    EXPECT_EQ(fail("1 2\r\n1 2\r3 4\n"), "no error");
    EXPECT_EQ(fail("1 2\n\n1\n"), "f: line 3: n is missing");
    EXPECT_EQ(fail("1 2\r\none 2"), "f: line 2: 'one' for x is not a number");
    EXPECT_EQ(fail("1e400 2"), "f: line 1: '1e400' for x is too large");
    EXPECT_EQ(fail("1 2.5"), "f: line 1: '2.5' for n is not an integer");
    EXPECT_EQ(fail("1 2\r1 2 3"), "f: line 2: unexpected '3' at the end of the line");
    EXPECT_EQ(fail(std::string_view("1 \0", 3)), "f: line 1: byte 0x00 is not text");
}

TEST(TextCursor, QuotesOneShortLineOfPrintableCharacters) {
    const std::string text = "\xff" + std::string(1000000, 'a');
    const auto message = message_of<UnreadableFile>([&] {
        TextCursor cursor(text, "f", {});
        static_cast<void>(cursor.next_line() ? cursor.real("x") : 0.0);
    });
    EXPECT_EQ(message, "f: line 1: '?" + std::string(39, 'a') + "...' for x is not a number");
}

} // namespace
} // namespace foldless
