#include <insonate/curriculum/Form.h>
#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/teaching/TeachingHere.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace insonate {
namespace {

using testing::Contains;
using testing::Field;

TEST(TeachingHereTest, NamesWhatComesAlong) {
  const auto names = teachingNames();
  ASSERT_TRUE(names) << names.error().message;
  EXPECT_THAT(names->cases, Contains("textbook"));
  EXPECT_THAT(names->cases, Contains("subclavian"));
  EXPECT_THAT(names->procedures, Contains(Field(&TeachingNames::Procedure::name, "internal_jugular")));
  EXPECT_THAT(names->procedures[0].positions, Contains("Trendelenburg 15"));
  EXPECT_EQ(names->metrics.size(), std::size_t{kMetricCount});
}

TEST(TeachingHereTest, TheCurriculumThatComesAlongCanBeTaught) {
  const auto names = teachingNames();
  ASSERT_TRUE(names);
  for (const std::string& name : curriculumPresetNames()) {
    const auto curriculum = loadCurriculum(name);
    ASSERT_TRUE(curriculum) << curriculum.error().message;
    const auto fine = checkNames(*curriculum, *names);
    EXPECT_TRUE(fine) << fine.error().message;
  }
}

TEST(TeachingHereTest, MetricsAreNamedForPeople) {
  const auto metrics = metricMeanings();
  const auto& time = metrics[static_cast<int>(Metric::TimeToVein)];
  EXPECT_EQ(time.title, "Time to vein");
  EXPECT_EQ(time.unit, "s");
  EXPECT_EQ(time.better, MetricMeaning::Better::Lower);
  EXPECT_FALSE(time.expert);
  EXPECT_EQ(metrics[static_cast<int>(Metric::NeedleInefficiency)].title, "Needle inefficiency");
  EXPECT_EQ(metrics[static_cast<int>(Metric::ArteryPunctures)].title, "Artery punctures");
  std::set<std::string> titles;
  for (const MetricMeaning& metric : metrics) titles.insert(metric.title);
  EXPECT_EQ(titles.size(), metrics.size()) << "two that are called the same";
}

TEST(TeachingHereTest, NormsAreThoseOfTheProcedure) {
  const auto procedure = loadProcedure("internal_jugular");
  ASSERT_TRUE(procedure);
  const auto metrics = metricMeanings(*procedure);
  for (const MetricNorm& norm : procedure->norms) {
    const MetricMeaning& meaning = metrics[static_cast<int>(norm.metric)];
    EXPECT_EQ(meaning.novice, norm.novice) << meaning.id;
    EXPECT_EQ(meaning.expert, norm.expert) << meaning.id;
  }
  EXPECT_FALSE(metrics[static_cast<int>(Metric::AttemptTime)].expert) << "of which none is known";
}

/// A misspelled metric would silently answer nothing.
TEST(TeachingHere, EachMetricThatAnswersAnItemExists) {
  int answered = 0;
  for (const std::string& name : formPresetNames()) {
    const auto form = loadForm(name);
    ASSERT_TRUE(form) << form.error().message;
    for (const FormSection& section : form->sections)
      for (const FormItem& item : section.items) {
        if (!item.evidence) continue;
        ++answered;
        for (const std::string& id : {item.evidence->metric, item.evidence->after})
          EXPECT_TRUE(id.empty() || std::ranges::find(metricTable(), id, &MetricDefinition::id) != metricTable().end())
              << name << ", " << item.name << ": " << id;
      }
  }
  EXPECT_GT(answered, 20);
}

}  // namespace
}  // namespace insonate
