#include "page/Charts.h"

#include "page/Page.h"

#include <insonate/curriculum/AttemptTable.h>

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

class Drawing {
 public:
  explicit Drawing(const AttemptChart& values) : values_(values) {
    double low = 0, high = values.limit.value_or(0);
    for (const auto& point : values.points)
      if (point) low = std::min(low, point->value), high = std::max(high, point->value);
    axis_ = axisOver(low, high);
  }

  Markup svg() const {
    const std::string label = values_.title + ", plotted against the attempt number; the table below lists the values.";
    return element("svg",
                   {{"viewBox", "0 0 " + px(kWidth) + " " + px(kHeight)},
                    {"role", "img"},
                    {"aria-label", label},
                    {"class", "chart"}},
                   grid() + limit() + curve() + marks());
  }

 private:
  double x(std::size_t index) const {
    const double steps = std::max<double>(1, double(values_.points.size()) - 1);
    return kLeft + 8 + (kWidth - kLeft - kRight - 16) * double(index) / steps;
  }
  double y(double value) const {
    return kTop + (kHeight - kTop - kBottom) * (axis_.high - value) / (axis_.high - axis_.low);
  }
  static Markup line(double x1, double y1, double x2, double y2, const std::string& kind) {
    return element("line", {{"x1", px(x1)}, {"y1", px(y1)}, {"x2", px(x2)}, {"y2", px(y2)}, {"class", kind}});
  }
  static Markup label(double atX, double atY, const std::string& anchor, const std::string& words) {
    return element("text", {{"x", px(atX)}, {"y", px(atY)}, {"text-anchor", anchor}}, words);
  }

  Markup grid() const {
    Markup all;
    for (double value = axis_.low; value < axis_.high + axis_.step / 2; value += axis_.step)
      all += line(kLeft, y(value), kWidth - kRight, y(value), "grid") +
             label(kLeft - 6, y(value) + 4, "end", numberOf(std::abs(value) < axis_.step / 2 ? 0 : value));
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
      if (mark == AttemptChart::Mark::Failed)
        all += line(atX - 4, atY - 4, atX + 4, atY + 4, "failed") + line(atX - 4, atY + 4, atX + 4, atY - 4, "failed");
      else
        all += element("circle", {{"cx", px(atX)},
                                  {"cy", px(atY)},
                                  {"r", "4"},
                                  {"class", mark == AttemptChart::Mark::Passed ? "passed" : "other"}});
    }
    return all;
  }

  const AttemptChart& values_;
  Axis axis_;
};

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

}  // namespace insonate::web
