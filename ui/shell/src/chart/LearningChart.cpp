#include <insonate/curriculum/LcCusum.h>
#include <insonate/curriculum/LearningCurve.h>
#include <insonate/ui/LearningChart.h>
#include <insonate/ui/Text.h>

#include <algorithm>
#include <vector>

namespace insonate::ui {
namespace {

constexpr double kRoom = 1.05;

using Tone = ChartContents::Tone;

void addExpertBand(ChartContents& picture, const MetricMeaning& meaning, double attempts, double least, double most) {
  if (!meaning.expert || meaning.better == MetricMeaning::Better::Neither) return;
  const bool lower = meaning.better == MetricMeaning::Better::Lower;
  const double edge = *meaning.expert;
  const double low = lower ? std::min({0.0, least, edge}) : edge;
  const double high = lower ? edge : std::max(most, edge) + (kRoom - 1) * std::max(std::abs(most), std::abs(edge));
  picture.bands.push_back(
      {tr("expert"), {{0.5, low}, {attempts + 0.5, low}}, {{0.5, high}, {attempts + 0.5, high}}, Tone::Good});
}

bool addCurve(ChartContents& picture, ValueKind kind, std::span<const std::optional<double>> values) {
  const auto curve = fitLearningCurve(values, kind);
  if (!curve) return false;
  ChartContents::Line line{tr("learning curve"), {}, Tone::Accent, Qt::SolidLine};
  ChartContents::Band band{tr("95 % interval"), {}, {}, Tone::Accent};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double attempt = double(i) + 1;
    const Interval interval = curve->bandAt(attempt);
    line.points.emplace_back(attempt, curve->at(attempt));
    band.low.emplace_back(attempt, interval.low), band.high.emplace_back(attempt, interval.high);
  }
  picture.bands.push_back(std::move(band));
  picture.lines.push_back(std::move(line));
  return true;
}

}  // namespace

ChartContents learningChart(const MetricMeaning& meaning, std::span<const std::optional<double>> values) {
  ChartContents picture;
  picture.title = QString::fromStdString(meaning.title);
  picture.xTitle = tr("attempt");
  picture.yTitle = QString::fromStdString(meaning.unit);
  std::vector<QPointF> dots;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i]) dots.emplace_back(double(i) + 1, *values[i]);
  if (dots.empty()) {
    picture.words =
        values.empty() ? tr("n/a: there are no attempts yet that count toward levels.") : tr("n/a: no data");
    return picture;
  }
  const auto [least, most] = std::ranges::minmax_element(dots, {}, &QPointF::y);
  addExpertBand(picture, meaning, double(values.size()), least->y(), most->y());
  if (!addCurve(picture, meaning.kind, values)) {
    ChartContents::Line mean{tr("mean of last %1 attempts").arg(kLastAttempts), {}, Tone::Accent, Qt::DashLine};
    const auto means = movingMean(values, kLastAttempts);
    for (std::size_t i = 0; i < means.size(); ++i)
      if (means[i]) mean.points.emplace_back(double(i) + 1, *means[i]);
    if (mean.points.size() > 1) picture.lines.push_back(std::move(mean));
  }
  picture.lines.push_back({tr("attempts"), std::move(dots), Tone::Text, Qt::NoPen, true});
  return picture;
}

ChartContents cusumChart(const std::vector<bool>& passes, const CusumRule& rule) {
  const std::vector<double> scores = LcCusum{rule.acceptable, rule.unacceptable}.series(passes);
  ChartContents picture;
  picture.title = tr("LC-CUSUM");
  picture.xTitle = tr("attempt");
  picture.yTitle = tr("score");
  if (scores.empty()) {
    picture.words = tr("n/a: there are no attempts at this level yet that count toward it.");
    return picture;
  }
  // The axis names the score; the legend has the rates of the limit in one line.
  ChartContents::Line line{{}, {}, Tone::Accent, Qt::SolidLine, scores.size() <= 60};
  for (std::size_t i = 0; i < scores.size(); ++i) line.points.emplace_back(double(i) + 1, scores[i]);
  picture.lines.push_back(std::move(line));
  picture.lines.push_back({tr("limit %1; failure rate: %2 % acceptable, %3 % unacceptable")
                               .arg(rule.limit)
                               .arg(100 * rule.acceptable)
                               .arg(100 * rule.unacceptable),
                           {{1, rule.limit}, {std::max(2.0, double(scores.size())), rule.limit}},
                           Tone::Good,
                           Qt::DashLine});
  picture.y = Interval{0, rule.limit * kRoom};
  return picture;
}

}  // namespace insonate::ui
