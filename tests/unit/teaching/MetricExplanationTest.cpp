#include <insonate/procedure/Procedure.h>
#include <insonate/teaching/MetricCatalog.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace insonate {
namespace {

std::string textOf(const std::vector<MetricExplanation>& parts, const std::string& heading) {
  const auto found = std::ranges::find(parts, heading, &MetricExplanation::heading);
  return found == parts.end() ? "(missing)" : found->text;
}

TEST(MetricExplanation, EachNormOfAProcedureHasItsSourceAndEachMetricItsDefinition) {
  const MetricCatalog& catalog = MetricCatalog::instance();
  const Procedure procedure = builtInProcedure("internal_jugular").value();
  ASSERT_FALSE(procedure.norms.empty());
  for (const MetricMeaning& meaning : catalog.all()) {
    const auto parts = catalog.explanationOf("internal_jugular", meaning);
    if (meaning.id == "points") {
      EXPECT_TRUE(parts.empty());
      continue;
    }
    const auto metric = std::ranges::find(metricTable(), meaning.id, &MetricDefinition::id);
    EXPECT_EQ(textOf(parts, "Definition"), metric->definition);
    const auto norm = std::ranges::find(procedure.norms, metric->metric, &MetricNorm::metric);
    if (norm == procedure.norms.end())
      EXPECT_EQ(textOf(parts, "Novice and expert values"), "none are known") << meaning.id;
    else
      EXPECT_EQ(textOf(parts, "Source of the novice and expert values"), norm->source) << meaning.id;
  }
}

TEST(MetricExplanation, AnUnknownProcedureHasNoSources) {
  const MetricMeaning& meaning = MetricCatalog::instance().all()[1];
  EXPECT_EQ(textOf(MetricCatalog::instance().explanationOf("unknown", meaning), "Novice and expert values"),
            "none are known");
}

TEST(MetricExplanation, PublishedValuesHaveFourDigitsAndAUnit) {
  EXPECT_EQ(publishedValue(4, ""), "4");
  EXPECT_EQ(publishedValue(41.25, "mm"), "41.25 mm");
  EXPECT_EQ(publishedValue(30, "deg"), "30\u00b0");
  EXPECT_EQ(publishedValue(123.456, "s"), "123.5 s");
}

}  // namespace
}  // namespace insonate
