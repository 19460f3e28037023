#include "page/Charts.h"

#include "page/Page.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Statistics.h>

#include <algorithm>
#include <cmath>

namespace insonate::web {
namespace {

constexpr double kWidth = 720, kHeight = 260, kLeft = 56, kRight = 12, kTop = 12, kBottom = 36;
constexpr int kTicks = 5;

struct Axis {
  double low = 0, high = 1, step = 0.25;
};

/// Round steps of 1, 2 or 5 times a power of ten.
Axis axisOver(double low, double high) {
  if (high - low < 1e-9) high = low + 1;
  const double rough = (high - low) / (kTicks - 1), power = std::pow(10, std::floor(std::log10(rough)));
  const double part = rough / power;
  const double step = power * (part <= 1 ? 1 : part <= 2 ? 2 : part <= 5 ? 5 : 10);
  return {std::floor(low / step) * step, std::ceil(high / step) * step, step};
}

std::string px(double value) {
  return numberOf(std::round(value * 10) / 10);
}

Markup line(double x1, double y1, double x2, double y2, const std::string& kind) {
  return element("line", {{"x1", px(x1)}, {"y1", px(y1)}, {"x2", px(x2)}, {"y2", px(y2)}, {"class", kind}});
}

Markup label(double atX, double atY, const std::string& anchor, const std::string& words) {
  return element("text", {{"x", px(atX)}, {"y", px(atY)}, {"text-anchor", anchor}}, words);
}

Markup cross(double atX, double atY, const std::string& kind) {
  return line(atX - 4, atY - 4, atX + 4, atY + 4, kind) + line(atX - 4, atY + 4, atX + 4, atY - 4, kind);
}

Markup dot(double atX, double atY, const std::string& radius, const std::string& kind) {
  return element("circle", {{"cx", px(atX)}, {"cy", px(atY)}, {"r", radius}, {"class", kind}});
}

Markup svgOf(const std::string& description, const Markup& content) {
  return element("svg",
                 {{"viewBox", "0 0 " + px(kWidth) + " " + px(kHeight)},
                  {"role", "img"},
                  {"aria-label", description},
                  {"class", "chart"}},
                 content);
}

/// Vertical axis of a chart.
double yOf(const Axis& axis, double value) {
  return kTop + (kHeight - kTop - kBottom) * (axis.high - value) / (axis.high - axis.low);
}

Markup gridOf(const Axis& axis) {
  Markup all;
  for (double value = axis.low; value < axis.high + axis.step / 2; value += axis.step)
    all += line(kLeft, yOf(axis, value), kWidth - kRight, yOf(axis, value), "grid") +
           label(kLeft - 6, yOf(axis, value) + 4, "end", numberOf(std::abs(value) < axis.step / 2 ? 0 : value));
  return all;
}

class Drawing {
 public:
  explicit Drawing(const AttemptChart& values) : values_(values) {
    double low = 0, high = values.limit.value_or(0);
    for (const auto& point : values.points)
      if (point) low = std::min(low, point->value), high = std::max(high, point->value);
    axis_ = axisOver(low, high);
  }

  Markup svg() const {
    return svgOf(values_.title + ", plotted against the attempt number; the table below lists the values.",
                 gridOf(axis_) + numbers() + limit() + curve() + marks());
  }

 private:
  double x(std::size_t index) const {
    const double steps = std::max<double>(1, double(values_.points.size()) - 1);
    return kLeft + 8 + (kWidth - kLeft - kRight - 16) * double(index) / steps;
  }
  double y(double value) const { return yOf(axis_, value); }

  Markup numbers() const {
    Markup all;
    const std::size_t count = values_.points.size(), every = std::max<std::size_t>(1, (count + 9) / 10);
    for (std::size_t i = 0; i < count; i += every)
      all += label(x(i), kHeight - kBottom + 16, "middle", std::to_string(i + 1));
    return all + label((kLeft + kWidth - kRight) / 2, kHeight - 4, "middle", "Attempt");
  }

  Markup limit() const {
    if (!values_.limit) return {};
    return line(kLeft, y(*values_.limit), kWidth - kRight, y(*values_.limit), "limit") +
           label(kWidth - kRight, y(*values_.limit) - 4, "end", values_.limitName);
  }

  Markup curve() const {
    std::string points;
    for (std::size_t i = 0; i < values_.points.size(); ++i)
      if (values_.points[i]) points += px(x(i)) + "," + px(y(values_.points[i]->value)) + " ";
    return element("polyline", {{"points", points}, {"class", "curve"}});
  }

  /// A pass is a dot, a failure a cross, so that color is not needed to distinguish them.
  Markup marks() const {
    Markup all;
    for (std::size_t i = 0; i < values_.points.size(); ++i) {
      if (!values_.points[i]) continue;
      const double atX = x(i), atY = y(values_.points[i]->value);
      const auto mark = values_.points[i]->mark;
      all += mark == AttemptChart::Mark::Failed
                 ? cross(atX, atY, "failed")
                 : dot(atX, atY, "4", mark == AttemptChart::Mark::Passed ? "passed" : "other");
    }
    return all;
  }

  const AttemptChart& values_;
  Axis axis_;
};

/// Draws one group in its column: box, whiskers, median, and a dot for each value beside the box.
Markup boxOf(const BoxChart::Group& group, const Axis& axis, double center) {
  constexpr double kHalf = 26, kBeside = 52, kSpread = 36, kGolden = 0.618034;
  const auto box = boxPlotOf(group.values);
  if (!box) return {};
  const auto across = [&](double value, double half, const std::string& kind) {
    return line(center - half, yOf(axis, value), center + half, yOf(axis, value), kind);
  };
  Markup all = line(center, yOf(axis, box->lowerWhisker), center, yOf(axis, box->lowerQuartile), "box") +
               line(center, yOf(axis, box->upperQuartile), center, yOf(axis, box->upperWhisker), "box") +
               across(box->lowerWhisker, kHalf / 2, "box") + across(box->upperWhisker, kHalf / 2, "box") +
               element("rect", {{"x", px(center - kHalf)},
                                {"y", px(yOf(axis, box->upperQuartile))},
                                {"width", px(2 * kHalf)},
                                {"height", px(yOf(axis, box->lowerQuartile) - yOf(axis, box->upperQuartile))},
                                {"class", "box"}}) +
               across(box->median, kHalf, "median");
  // The dots are spread sideways, so that those of similar height do not hide each other.
  const auto marked = group.marked ? std::ranges::find(group.values, *group.marked) : group.values.end();
  for (std::size_t i = 0; i < group.values.size(); ++i)
    if (static_cast<std::ptrdiff_t>(i) != marked - group.values.begin())
      all +=
          dot(center + kBeside + kSpread * std::fmod(double(i) * kGolden, 1), yOf(axis, group.values[i]), "3", "other");
  if (group.marked) all += cross(center, yOf(axis, *group.marked), "marked");
  return all;
}

Markup drawingOf(const BoxChart& contents) {
  double low = 0, high = 0;
  for (const BoxChart::Group& group : contents.groups)
    for (const double value : group.values) low = std::min(low, value), high = std::max(high, value);
  const Axis axis = axisOver(low, high);
  const double column = (kWidth - kLeft - kRight) / double(contents.groups.size());
  Markup all = gridOf(axis);
  for (std::size_t i = 0; i < contents.groups.size(); ++i) {
    const double center = kLeft + column * (double(i) + 0.5);
    all += boxOf(contents.groups[i], axis, center) +
           label(center, kHeight - kBottom + 18, "middle", contents.groups[i].name);
  }
  return svgOf(contents.title + "; the table below has the numbers.", all);
}

std::vector<Markup> numbersOf(const BoxChart::Group& group) {
  std::vector<Markup> cells{text(group.name), text(std::to_string(group.values.size()))};
  const auto box = boxPlotOf(group.values);
  const auto [least, most] = std::ranges::minmax(group.values);
  const std::vector<double> numbers =
      box ? std::vector{least, box->lowerQuartile, box->median, box->upperQuartile, most} : std::vector<double>{};
  for (std::size_t i = 0; i < 5; ++i) cells.push_back(text(i < numbers.size() ? numberOf(numbers[i]) : "none"));
  return cells;
}

}  // namespace

Markup chart(const AttemptChart& values) {
  const bool any = std::ranges::any_of(values.points, [](const auto& point) { return point.has_value(); });
  if (!any) return paragraph("There are no values yet.");
  std::vector<std::vector<Markup>> rows;
  bool anyJudged = false;
  for (const auto& point : values.points) anyJudged = anyJudged || (point && point->mark != AttemptChart::Mark::Other);
  for (std::size_t i = 0; i < values.points.size(); ++i) {
    const auto& point = values.points[i];
    rows.push_back({text(std::to_string(i + 1)), text(point ? numberOf(point->value) : "no value")});
    if (anyJudged)
      rows.back().push_back(text(!point                                      ? ""
                                 : point->mark == AttemptChart::Mark::Passed ? "passed"
                                 : point->mark == AttemptChart::Mark::Failed ? "failed"
                                                                             : ""));
  }
  std::vector<std::string> titles{"Attempt", values.unit.empty() ? "Value" : "Value, " + values.unit};
  if (anyJudged) titles.emplace_back("Result");
  Markup caption = text(values.title);
  if (anyJudged) caption += element("span", {{"class", "quiet"}}, " (dot: passed, cross: failed)");
  return element("figure", {},
                 element("figcaption", {}, caption) + Drawing(values).svg() +
                     element("details", {}, element("summary", {}, "Values") + table(values.title, titles, rows)));
}

Markup drawBoxes(const BoxChart& contents) {
  if (std::ranges::all_of(contents.groups, [](const auto& group) { return group.values.empty(); }))
    return paragraph("There are no values yet.");
  std::vector<std::vector<Markup>> rows;
  for (const BoxChart::Group& group : contents.groups)
    if (!group.values.empty()) rows.push_back(numbersOf(group));
  const std::string unit = contents.unit.empty() ? "" : ", " + contents.unit;
  return element(
      "figure", {},
      element("figcaption", {}, contents.title + unit) + drawingOf(contents) +
          table(contents.title + unit,
                {"Group", "People", "Minimum", "Lower quartile", "Median", "Upper quartile", "Maximum"}, rows));
}

}  // namespace insonate::web
