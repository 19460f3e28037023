#include <insonate/bench/SvgPlot.h>

#include <gmock/gmock.h>

#include <cmath>
#include <regex>

namespace insonate {
namespace {

using testing::HasSubstr;
using testing::Not;

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++n;
  return n;
}

/// Every element that is opened is closed, in order.
bool isWellFormed(const std::string& svg) {
  std::vector<std::string> open;
  const std::regex tag(R"(<(/?)([a-z]+)[^<>]*?(/?)>)");
  for (std::sregex_iterator it(svg.begin(), svg.end(), tag), end; it != end; ++it) {
    if ((*it)[3].length() > 0) continue;
    if ((*it)[1].length() == 0) {
      open.push_back((*it)[2]);
    } else {
      if (open.empty() || open.back() != (*it)[2]) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

/// Centres of the marks of the first series' color, legend left out.
std::vector<std::pair<double, double>> marks(const std::string& svg) {
  std::vector<std::pair<double, double>> found;
  const std::regex circle("<circle cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\" r=\"4\" fill=\"#0072b2\"");
  for (std::sregex_iterator it(svg.begin(), svg.end(), circle), end; it != end; ++it)
    found.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  found.pop_back();
  return found;
}

LineChart chartOf(std::vector<PlotPoint> points, bool logarithmic) {
  return {.title = "Speed",
          .subtitle = "",
          .x = {.title = "time", .logarithmic = logarithmic},
          .y = {.title = "error", .logarithmic = logarithmic},
          .series = {{.name = "cpu", .points = std::move(points)}},
          .levels = {}};
}

TEST(SvgPlot, PutsPointsInOrderAndProportion) {
  const auto at = marks(svgOf(chartOf({{0, 0, ""}, {5, 1, ""}, {10, 4, ""}}, false)));
  ASSERT_EQ(at.size(), 3U);
  EXPECT_NEAR(at[1].first - at[0].first, at[2].first - at[1].first, 0.11);
  EXPECT_NEAR((at[0].second - at[2].second) / (at[0].second - at[1].second), 4, 0.01);  // upwards in the image
}

TEST(SvgPlot, LogarithmicAxesSpaceFactorsEvenly) {
  const auto at = marks(svgOf(chartOf({{1, 100, ""}, {10, 10, ""}, {100, 1, ""}}, true)));
  ASSERT_EQ(at.size(), 3U);
  EXPECT_NEAR(at[1].first - at[0].first, at[2].first - at[1].first, 0.11);
  EXPECT_NEAR(at[1].second - at[0].second, at[2].second - at[1].second, 0.11);
}

TEST(SvgPlot, LeavesOutWhatAnAxisCannotShow) {
  EXPECT_EQ(marks(svgOf(chartOf({{1, 1, ""}, {0, 5, ""}, {-3, 5, ""}, {NAN, 1, ""}, {2, INFINITY, ""}}, true))).size(),
            1U);
  EXPECT_EQ(marks(svgOf(chartOf({{1, 1, ""}, {-3, 5, ""}, {NAN, 1, ""}}, false))).size(), 2U);
}

TEST(SvgPlot, TheLegendTellsDashedFromWholeLines) {
  LineChart chart = chartOf({{1, 1, ""}, {2, 2, ""}}, false);
  chart.series.push_back({.name = "dashed", .points = {{1, 2, ""}, {2, 1, ""}}, .dashed = true});
  const std::string svg = svgOf(chart);
  EXPECT_EQ(count(svg, "<polyline"), 4) << "each in the chart and in the legend";
  EXPECT_EQ(count(svg, "stroke-dasharray"), 2);
}

TEST(SvgPlot, EscapesTextAndStaysWellFormed) {
  LineChart chart = chartOf({{1, 2, "<a> & \"b\""}, {2, 3, ""}}, true);
  chart.title = "errors < 1 % & falling";
  chart.levels = {{"limit > 0", 2.5}};
  const std::string svg = svgOf(chart);
  EXPECT_THAT(svg, HasSubstr("errors &lt; 1 % &amp; falling"));
  EXPECT_THAT(svg, HasSubstr("&lt;a&gt; &amp; &quot;b&quot;"));
  EXPECT_TRUE(isWellFormed(svg));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(SvgPlot, ChartsOfNothingOrOfOnePointStandUp) {
  for (const bool logarithmic : {false, true}) {
    EXPECT_THAT(svgOf(chartOf({}, logarithmic)), HasSubstr("nothing to show"));
    const std::string one = svgOf(chartOf({{3, 3, ""}}, logarithmic));
    EXPECT_TRUE(isWellFormed(one));
    EXPECT_THAT(one, Not(HasSubstr("nan")));
    EXPECT_THAT(one, Not(HasSubstr("inf")));
  }
  EXPECT_THAT(svgOf(StackedBars{}), HasSubstr("nothing to show"));
}

TEST(SvgPlot, BarsStackToTheirSum) {
  const std::string svg = svgOf(StackedBars{.title = "Stages",
                                            .subtitle = "",
                                            .valueTitle = "ms",
                                            .bars = {"one", "two"},
                                            .parts = {{"a", {1, 2}}, {"b", {3}}, {"c", {NAN, -1}}}});
  EXPECT_TRUE(isWellFormed(svg));
  const std::regex bar("<rect x=\"([0-9.]+)\" y=\"([0-9.]+)\" width=\"([0-9.]+)\" height=\"28.0\"");
  std::vector<double> left, width;
  for (std::sregex_iterator it(svg.begin(), svg.end(), bar), end; it != end; ++it)
    left.push_back(std::stod((*it)[1])), width.push_back(std::stod((*it)[3]));
  ASSERT_EQ(left.size(), 6U);  // three parts of each bar
  EXPECT_NEAR(width[1], 3 * width[0], 0.3);
  EXPECT_NEAR(left[1], left[0] + width[0], 0.11);
  EXPECT_NEAR(width[3], 2 * width[0], 0.2);
  EXPECT_EQ(width[2], 0);
  EXPECT_EQ(width[4] + width[5], 0);
  EXPECT_EQ(count(svg, "stroke=\"#fff\" fill=\"#0072b2\""), 2);
}

}  // namespace
}  // namespace insonate
