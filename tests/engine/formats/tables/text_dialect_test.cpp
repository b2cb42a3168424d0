// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/text_dialect.h"

#include <gtest/gtest.h>

#include "engine/error.h"

namespace ilot {
namespace {

std::vector<double> values_of(const std::vector<std::string>& rows, std::size_t names = 0) {
  const FoundDialect found = find_dialect(rows, names, {}, "t.txt: line 1");
  std::vector<double> values(found.columns);
  std::vector<std::string_view> fields;
  if (!parse_row(rows[0], found.dialect, fields, values)) values.clear();
  return values;
}

std::string refusal_of(const std::vector<std::string>& rows, std::size_t names = 0) {
  try {
    find_dialect(rows, names, {}, "t.txt: line 1");
  } catch (const Error& fault) {
    EXPECT_EQ(fault.code(), ExitCode::usage);
    return fault.what();
  }
  return {};
}

TEST(TextDialect, ReadsWhatProgramsWrite) {
  const std::vector<double> wanted{651000.123, 6861000.456, 55.1};
  for (const std::string row : {"651000.123 6861000.456 55.1",
                                "651000.123\t6861000.456\t55.1",
                                "651000.123,6861000.456,55.1",
                                "651000.123;6861000.456;55.1",
                                "651000.123, 6861000.456, 55.1",
                                "651000.123 ; 6861000.456 ; 55.1;",
                                "651000,123;6861000,456;55,1",
                                "651000,123\t6861000,456\t55,1",
                                "651000,123 6861000,456 55,1",
                                "\"651000,123\",\"6861000,456\",\"55,1\"",
                                "651 000,123;6 861 000,456;55,1",
                                "651 000,123\t6 861 000,456\t55,1",
                                "651\xC2\xA0"
                                "000,123;6\xC2\xA0"
                                "861\xC2\xA0"
                                "000,456;55,1",
                                "651\xE2\x80\xAF"
                                "000,123 6\xE2\x80\xAF"
                                "861\xE2\x80\xAF"
                                "000,456 55,1",
                                "651\xA0"
                                "000,123;6\xA0"
                                "861\xA0"
                                "000,456;55,1",
                                "651.000,123;6.861.000,456;55,1",
                                "651'000.123;6'861'000.456;55.1",
                                "651'000.123,6'861'000.456,55.1",
                                "\"651,000.123\",\"6,861,000.456\",\"55.1\"",
                                "651,000.123;6,861,000.456;55.1",
                                "+651000,123;6,861000456e6;551e-1"})
    EXPECT_EQ(values_of({row}, 3), wanted) << row;
}

TEST(TextDialect, TheFourFormsOfDecimalCommasNeedNoHeader) {
  const std::vector<double> wanted{651000.123, 6861000.456, 55.1};
  for (const std::string row : {"651000,123;6861000,456;55,1", "651000,123\t6861000,456\t55,1",
                                "651000,123 6861000,456 55,1", "\"651000,123\",\"6861000,456\",\"55,1\""})
    EXPECT_EQ(values_of({row}), wanted) << row;
}

TEST(TextDialect, APointIsADecimalPointUnlessItCannotBe) {
  EXPECT_EQ(values_of({"1.234 5.678 9.012"}), (std::vector<double>{1.234, 5.678, 9.012}));
  EXPECT_EQ(values_of({"1.234;5.678;9.012"}), (std::vector<double>{1.234, 5.678, 9.012}));
  EXPECT_EQ(values_of({"651.000;6.861.000;55"}), (std::vector<double>{651000, 6861000, 55}));
  std::vector<std::string> rows(99, "1.234;5.678;9.012");
  rows.push_back("1.234,5;5.678;9.012");
  EXPECT_EQ(values_of(rows), (std::vector<double>{1.234, 5.678, 9.012})) << "one row is not the dialect of all";
}

TEST(TextDialect, WholeNumbersBetweenCommasStayWhole) {
  EXPECT_EQ(values_of({"1,2,3"}), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(values_of({"1,2,3,4"}), (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(values_of({"1,2,3,255,128,64"}, 6), (std::vector<double>{1, 2, 3, 255, 128, 64})) << "six names";
  EXPECT_EQ(values_of({"1,2,3,255,128,64"}, 3), (std::vector<double>{1.2, 3.255, 128.64})) << "three names";
  std::vector<std::string> rows;
  for (int i = 0; i < 60; ++i) rows.push_back(std::to_string(1000 + i) + ",2000,30,255,128,64");
  EXPECT_EQ(values_of(rows).size(), 6u) << "of so many decimals one would begin with a zero";
}

TEST(TextDialect, WhatCanBeReadInTwoWaysIsRefusedWithBothAndTheWayOut) {
  for (const std::string row : {"1,234;5,678;9,012", "1,234 5,678 9,012", "1 234\t5 678\t9 012",
                                "651000,123,6861000,456,55,1", "\"1,234\",\"5,678\",\"9,012\""}) {
    const std::string message = refusal_of({row});
    EXPECT_NE(message.find("two ways"), std::string::npos) << row << ": " << message;
    EXPECT_EQ(message.find("t.txt: line 1: "), 0u) << message;
    const std::size_t option = message.find("--text-dialect ");
    ASSERT_NE(option, std::string::npos);
    const std::string words = message.substr(option + 15, message.find(' ', option + 15) - option - 15);
    std::vector<double> values(3);
    std::vector<std::string_view> fields;
    EXPECT_NO_THROW(dialect_of_words(words)) << words;
  }
  const std::string both = refusal_of({"1,234;5,678;9,012"});
  EXPECT_NE(both.find("1234 | 5678 | 9012"), std::string::npos) << both;
  EXPECT_NE(both.find("1.234 | 5.678 | 9.012"), std::string::npos) << both;
  EXPECT_EQ(refusal_of({"1,234;5,678;9,012", "0,125;5,678;9,012"}), "") << "no thousands begin with a zero";
  EXPECT_EQ(refusal_of({"1,234;5,678;9,012", "1,5;5,678;9,012"}), "") << "thousands are three digits";
}

TEST(TextDialect, HalfAndHalfIsRefused) {
  std::vector<std::string> rows(5, "1.5;2.5;3.5");
  rows.insert(rows.end(), 5, "1,5;2,5;3,5");
  EXPECT_NE(refusal_of(rows).find("written in two ways"), std::string::npos);
  rows.push_back("1.5;2.5;3.5");
  EXPECT_EQ(values_of(rows), (std::vector<double>{1.5, 2.5, 3.5})) << "the greater part decides";
}

TEST(TextDialect, NumbersThatAreNone) {
  const TextDialect french{Separator::semicolon, ',', ' '};
  double value = 0;
  for (const char* text : {"", "-", "1,", ",5", "1,5,5", "1.5", "1 23", "12 34 567", "0 123", "1,5x", "1,5 e3", "--1"})
    EXPECT_FALSE(parse_number(text, french, value)) << text;
  for (const char* text : {"-1,5", "+1 234,5", "1e3", "nan", "-inf", " 7 "})
    EXPECT_TRUE(parse_number(text, french, value)) << text;
  EXPECT_TRUE(parse_number("-1 234 567,25", french, value));
  EXPECT_EQ(value, -1234567.25);
}

TEST(TextDialect, DecimalsThatAreCarried) {
  const TextDialect point, comma{Separator::blank, ',', 0};
  EXPECT_EQ(decimals_of("651000.1230", point), 3);
  EXPECT_EQ(decimals_of("651000", point), 0);
  EXPECT_EQ(decimals_of("651000.000", point), 0);
  EXPECT_EQ(decimals_of("6.51000123e5", point), 3);
  EXPECT_EQ(decimals_of("5e-3", point), 3);
  EXPECT_EQ(decimals_of("55,12", comma), 2);
  EXPECT_EQ(decimals_of("nan", point), 0);
}

TEST(TextDialect, WordsThereAndBack) {
  for (const char* words : {"blank,decimal-point", "semicolon,decimal-comma,thousands-blank",
                            "tab,decimal-comma,thousands-point", "comma,decimal-point,thousands-apostrophe"})
    EXPECT_EQ(words_of(dialect_of_words(words)), words);
  EXPECT_EQ(dialect_of_words("tab"), (TextDialect{Separator::tab, '.', 0}));
  for (const char* words : {"", "decimal-comma", "semikolon", "semicolon,decimal-comma,thousands-comma", "tab,,"})
    EXPECT_THROW(dialect_of_words(words), Error) << words;
}

}  // namespace
}  // namespace ilot
