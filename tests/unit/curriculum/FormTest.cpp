#include <insonate/curriculum/Form.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace insonate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A form of four items, with a piece of its text replaced.
std::string formWith(const std::string& piece, const std::string& other) {
  std::string text = R"({"name": "f", "title": "A form", "version": 3, "purpose": "checklist",
    "scales": [{"name": "done", "options": [{"name": "yes", "title": "Done", "points": 1},
      {"name": "no", "title": "Not done", "points": 0}, {"name": "not_seen", "title": "Not seen"}]}],
    "sections": [{"title": "Before", "items": [
      {"name": "asepsis", "title": "Disinfects", "kind": "choice", "needed": true, "scale": "done"},
      {"name": "artery", "title": "Spares the artery", "kind": "choice",
       "options": [{"name": "1", "title": "No", "points": 1}, {"name": "5", "title": "Yes", "points": 5}]}]},
     {"title": "After", "items": [
      {"name": "years", "title": "Years", "kind": "number", "least": 0, "most": 60},
      {"name": "comment", "title": "Comment", "kind": "text"}]}]})";
  const auto at = text.find(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  return text.replace(at, piece.size(), other);
}

Form form() {
  const auto parsed = parseForm(formWith("checklist", "checklist"));
  EXPECT_TRUE(parsed) << (parsed ? "" : parsed.error().message);
  return parsed ? *parsed : Form{};
}

TEST(Form, IsReadAsItIsWritten) {
  const Form f = form();
  EXPECT_EQ(f.version, 3);
  EXPECT_EQ(f.purpose, Form::Purpose::Checklist);
  ASSERT_TRUE(f.item("asepsis"));
  EXPECT_TRUE(f.item("asepsis")->needed);
  EXPECT_EQ(f.item("asepsis")->options.size(), 3U);
  EXPECT_EQ(f.item("asepsis")->options[2].points, std::nullopt);
  EXPECT_EQ(f.item("years")->maximum, 60);
  EXPECT_EQ(f.item("comment")->kind, FormItem::Kind::Text);
  EXPECT_EQ(f.item("nothing"), nullptr);
}

/// A metric within the limits means done, beyond them not done or nothing, and without a value nothing.
TEST(Form, MetricsOfAnAttemptAnswerItems) {
  const auto answerOf = [](const std::string& from, std::optional<double> value) {
    const auto parsed = parseForm(formWith("\"scale\": \"done\"", "\"scale\": \"done\", \"from\": " + from));
    EXPECT_TRUE(parsed) << (parsed ? "" : parsed.error().message);
    const FormAnswers answers = answersFrom(*parsed, {{"other", 1, 5}, {"passes", 1, value}});
    return answerText(*parsed->item("asepsis"), answers);
  };
  const std::string atMost = R"({"metric": "passes", "most": 3})";
  EXPECT_EQ(answerOf(atMost, 3), "Done");
  EXPECT_EQ(answerOf(atMost, 4), "Not done");
  EXPECT_EQ(answerOf(atMost, std::nullopt), "");
  const std::string between = R"({"metric": "passes", "least": 1, "most": 3, "proves": "done"})";
  EXPECT_EQ(answerOf(between, 1), "Done");
  EXPECT_EQ(answerOf(between, 0), "");
  const std::string wrongOnly = R"({"metric": "passes", "most": 3, "proves": "not done"})";
  EXPECT_EQ(answerOf(wrongOnly, 3), "");
  EXPECT_EQ(answerOf(wrongOnly, 4), "Not done");
  EXPECT_EQ(answerOf(R"({"metric": "passes", "most": 3, "after": "other"})", 3), "Done");
  EXPECT_EQ(answerOf(R"({"metric": "passes", "most": 3, "after": "absent"})", 3), "") << "it never came to that";
  EXPECT_EQ(answerOf(R"({"metric": "absent", "least": 1})", 3), "");
}

TEST(Form, BadInputIsToldWhereAndWhatElse) {
  struct Case {
    const char *piece, *other, *sentence;
  };
  for (const Case& c : std::initializer_list<Case>{
           {"{\"name\": \"f\"", "{{", "The form is not valid JSON: line 1"},
           {"\"checklist\"", "\"checks\"", "has the unknown purpose 'checks'; did you mean 'checklist'?"},
           {"\"scale\": \"done\"", "\"scale\": \"dome\"", "item 'asepsis' has the unknown scale 'dome'; did you mean"},
           {"\"scale\": \"done\"", "\"options\": []", "item 'asepsis' offers fewer than two options"},
           {", \"scale\": \"done\"", "", "item 'asepsis' needs one of 'scale' and 'options'."},
           {"\"scale\": \"done\"", "\"scale\": \"done\", \"from\": {\"metric\": \"passes\"}",
            "item 'asepsis', from, needs 'least' or 'most'."},
           {"\"kind\": \"text\"", "\"kind\": \"text\", \"from\": {\"metric\": \"passes\", \"least\": 1}",
            "item 'comment' has 'from', which goes with the kind 'choice'."},
           {"\"kind\": \"text\"", "\"kind\": \"prose\"", "item 'comment' has the unknown kind 'prose'"},
           {"\"most\": 60", "\"most\": -1", "item 'years' needs a number from 0"},
           {"\"artery\"", "\"asepsis\"", "item 'asepsis' occurs twice"},
           {"\"years\"", "\"asepsis\"", "item 'asepsis' occurs twice"},
           {"{\"name\": \"no\"", "{\"name\": \"yes\"", "option 'yes' occurs twice"},
           {"\"points\": 5", "\"points\": \"five\"", "needs a number from -1000 to 1000 as 'points'"}}) {
    const auto parsed = parseForm(formWith(c.piece, c.other));
    ASSERT_FALSE(parsed) << c.other;
    EXPECT_THAT(parsed.error().message, HasSubstr(c.sentence));
  }
  EXPECT_THAT(parseForm(R"({"name": "f", "title": "F", "version": 1, "purpose": "rating"})").error().message,
              HasSubstr("asks nothing"));
}

TEST(Form, AnswersAreCheckedItemByItem) {
  EXPECT_TRUE(checkAnswers(form(), {{"asepsis", "not_seen"}}).empty());
  EXPECT_TRUE(checkAnswers(form(), {{"asepsis", "yes"}, {"artery", "5"}, {"years", 0.0}, {"comment", "Good"}}).empty());
  const auto errors = checkAnswers(form(), {{"artery", "3"}, {"years", 61.0}, {"comment", 4.0}, {"other", "x"}});
  std::vector<std::string> items, sentences;
  for (const AnswerError& error : errors) items.push_back(error.item), sentences.push_back(error.sentence);
  EXPECT_THAT(items, ElementsAre("asepsis", "artery", "years", "comment", "other"));
  EXPECT_THAT(sentences, ElementsAre("'Disinfects' needs an answer.", "'Spares the artery' needs one of 1, 5.",
                                     "'Years' needs a number from 0 to 60.", "'Comment' needs a text.",
                                     "'other' is not an item of 'A form'; leave it out."));
  EXPECT_EQ(checkAnswers(form(), {{"asepsis", 1.0}}).size(), 1U);
  EXPECT_EQ(checkAnswers(form(), {{"asepsis", "yes"}, {"years", std::numeric_limits<double>::quiet_NaN()}}).size(), 1U);
  EXPECT_EQ(checkAnswers(form(), {{"asepsis", "yes"}, {"comment", std::string(20'000, 'x')}}).size(), 1U);
}

TEST(Form, RatersWriteNotesToItems) {
  const Form f = form();
  EXPECT_TRUE(f.acceptsNote(*f.item("asepsis")));
  EXPECT_FALSE(f.acceptsNote(*f.item("comment")));
  const std::string hostile = "=cmd|' /C calc'!A0 <b>&amp;</b> \"%1\"\n";
  FormAnswers answers{{"asepsis", "yes"}, {noteKey(*f.item("asepsis")), hostile}};
  EXPECT_TRUE(checkAnswers(f, answers).empty());
  EXPECT_EQ(parseAnswers(answersText(answers)), answers);
  EXPECT_EQ(noteText(*f.item("asepsis"), answers), hostile);
  EXPECT_EQ(answerText(*f.item("asepsis"), answers), "Done");
  EXPECT_EQ(answerText(*f.item("years"), {{"years", 2.5}}), "2.5");
  EXPECT_EQ(answerText(*f.item("years"), {}), "");

  answers["comment:note"] = "beside a text";
  answers["nothing:note"] = "beside nothing";
  answers["years:note"] = 7.0;
  answers["artery:note"] = std::string(10'001, 'x');
  const auto errors = checkAnswers(f, answers);
  ASSERT_EQ(errors.size(), 4U);
  EXPECT_THAT(errors[0].sentence, HasSubstr("The note 'artery:note' is too long"));
  EXPECT_THAT(errors[1].sentence, HasSubstr("'comment:note' is not an item"));
  EXPECT_THAT(errors[2].sentence, HasSubstr("'nothing:note' is not an item"));
  EXPECT_THAT(errors[3].sentence, HasSubstr("The note 'years:note' needs a text"));

  Form asked = f;
  asked.purpose = Form::Purpose::Questionnaire;
  EXPECT_EQ(checkAnswers(asked, {{"asepsis", "yes"}, {"asepsis:note", "x"}}).size(), 1U);
}

TEST(Form, ScoreIsOfWhatCouldBeSeen) {
  auto score = formScore(form(), {{"asepsis", "yes"}, {"artery", "1"}, {"years", 7.0}});
  EXPECT_EQ(score.points, 2);
  EXPECT_EQ(score.maxPoints, 6);
  EXPECT_NEAR(*score.percent, 100 / 3.0, 1e-12);
  EXPECT_EQ(score.scored, 2);
  score = formScore(form(), {{"asepsis", "not_seen"}, {"artery", "5"}});
  EXPECT_EQ(score.percent, 100);
  EXPECT_EQ(score.scored, 1);
  EXPECT_EQ(score.unscored, 1);
  EXPECT_FALSE(formScore(form(), {}).percent);
  EXPECT_EQ(formScore(form(), {{"asepsis", 1.0}}).unscored, 2);
}

TEST(Form, AnswersAreKeptAsJson) {
  const FormAnswers answers{{"a", "text \"quoted\""}, {"b", 2.5}};
  EXPECT_EQ(answersText(answers), R"({"a":"text \"quoted\"","b":2.5})");
  EXPECT_EQ(*parseAnswers(answersText(answers)), answers);
  EXPECT_THAT(parseAnswers("[]").error().message, HasSubstr("must be an object"));
  EXPECT_THAT(parseAnswers("{\"a\": null}").error().message, HasSubstr("'a' must be a text or a number"));
  EXPECT_THAT(parseAnswers("{").error().message, HasSubstr("not valid JSON"));
}

TEST(Form, PresetsAreFine) {
  ASSERT_THAT(formPresetNames(), ElementsAre("simulator_questionnaire", "jugular_checklist", "line_checklist",
                                             "global_rating", "debrief"));
  for (const std::string& name : formPresetNames()) {
    const auto preset = loadForm(name);
    ASSERT_TRUE(preset) << preset.error().message;
    EXPECT_EQ(preset->name, name);
    EXPECT_FALSE(preset->source.empty());
  }
}

TEST(Form, TheQuestionnaireAsksWhatTheAppendixAsks) {
  const auto preset = loadForm("simulator_questionnaire");
  ASSERT_TRUE(preset) << preset.error().message;
  EXPECT_EQ(preset->item("specialty")->options.size(), 6U);
  EXPECT_EQ(preset->item("training_year")->options.size(), 6U);
  EXPECT_EQ(preset->item("lines_last_year")->options.size(), 9U);
  EXPECT_EQ(preset->item("lines_ever")->options, preset->item("lines_last_year")->options);
  int scales = 0, comments = 0;
  for (const FormSection& section : preset->sections)
    for (const FormItem& item : section.items) {
      scales += item.options.size() == 5;
      comments += item.name.ends_with("_comment");
    }
  EXPECT_EQ(scales, 12);  // four on realism, skin, two hands, five on importance, use
  EXPECT_EQ(comments, 7);
}

TEST(Form, AFullChecklistIsAHundredPercentAndAMiddlingRatingIsThree) {
  const auto checklist = loadForm("jugular_checklist"), rating = loadForm("global_rating");
  ASSERT_TRUE(checklist && rating);
  FormAnswers done, middling;
  for (const FormSection& section : checklist->sections)
    for (const FormItem& item : section.items) done[item.name] = "done";
  EXPECT_TRUE(checkAnswers(*checklist, done).empty());
  EXPECT_EQ(formScore(*checklist, done).percent, 100);
  EXPECT_EQ(formScore(*checklist, done).scored, 22);
  for (const FormItem& item : rating->sections[0].items)
    if (item.options.size() == 5) middling[item.name] = "3";
  EXPECT_EQ(formScore(*rating, middling).points, 21);
  EXPECT_EQ(formScore(*rating, middling).maxPoints, 35);
}

}  // namespace
}  // namespace insonate
