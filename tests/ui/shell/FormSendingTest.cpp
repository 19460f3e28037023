#include <insonate/ui/FormSending.h>

#include <gtest/gtest.h>

namespace {

using namespace insonate;

TEST(FormSending, TheSameAnswersKeepTheirIdUntilTheyAreStored) {
  ui::FormSending sending;
  const FilledForm form{.form = "cvc", .formVersion = 1, .person = "trainee", .by = "rater", .answers = R"({"a":"1"})"};
  const std::string first = sending.identified(form).id;
  EXPECT_EQ(first.size(), 36U);
  EXPECT_EQ(sending.identified(form).id, first) << "nobody knows whether it arrived";
  FilledForm corrected = form;
  corrected.answers = R"({"a":"2"})";
  const std::string second = sending.identified(corrected).id;
  EXPECT_NE(second, first) << "other answers are another form";
  FilledForm another = corrected;
  another.by = "another rater";
  EXPECT_NE(sending.identified(another).id, second);
}

TEST(FormSending, WhatIsStoredIsAnotherFormTheNextTime) {
  ui::FormSending sending;
  const FilledForm form{.form = "workload", .formVersion = 1, .person = "trainee", .answers = "{}"};
  const std::string first = sending.identified(form).id;
  sending.stored();
  EXPECT_NE(sending.identified(form).id, first);
}

}  // namespace
