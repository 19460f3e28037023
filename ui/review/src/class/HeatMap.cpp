#include "HeatMap.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/Statistics.h>

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::review {
namespace {

/// Cividis at 0, 25, 50, 75 and 100 %.
constexpr std::array<std::array<int, 3>, 5> kCividis{
    {{0, 34, 78}, {63, 77, 107}, {124, 123, 120}, {188, 175, 111}, {254, 232, 56}}};

}  // namespace

HeatMap heatMapOf(std::span<const AttemptFacts> attempts) {
  const MetricBook& book = MetricBook::here();
  std::map<std::string, std::vector<const AttemptFacts*>> byPerson;
  for (const AttemptFacts& attempt : attempts)
    if (counts(attempt)) byPerson[attempt.person].push_back(&attempt);
  HeatMap map;
  for (const auto& [person, theirs] : byPerson) {
    auto& row = map[person];
    for (std::size_t i = 0; i < book.all().size(); ++i) {
      std::vector<double> values, shares;
      for (const AttemptFacts* attempt : theirs) {
        if (const auto value = valueIn(*attempt, book.all()[i])) values.push_back(*value);
        if (const auto share = shareIn(*attempt, book.all()[i])) shares.push_back(*share);
      }
      row.push_back({meanValue(values), meanValue(shares), int(values.size())});
    }
  }
  return map;
}

QColor heatColour(double share) {
  const double at = std::clamp(share, 0.0, 100.0) / 100 * (kCividis.size() - 1);
  const auto low = std::min(std::size_t(at), kCividis.size() - 2);
  const double part = at - double(low);
  const auto mixed = [&](int channel) {
    return int(std::lround(kCividis[low][channel] * (1 - part) + kCividis[low + 1][channel] * part));
  };
  return {mixed(0), mixed(1), mixed(2)};
}

QColor inkOn(const QColor& ground) {
  // Relative luminance of WCAG 2; black and white have equal contrast at 0.18.
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const double luminance =
      0.2126 * linear(ground.redF()) + 0.7152 * linear(ground.greenF()) + 0.0722 * linear(ground.blueF());
  return luminance > 0.18 ? QColor(Qt::black) : QColor(Qt::white);
}

QString heatWords(const std::optional<double>& share) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("Review", text); };
  if (!share) return tr("no published values");
  return *share >= 99   ? tr("as an expert")
         : *share >= 67 ? tr("near expert")
         : *share >= 34 ? tr("midway")
         : *share > 1   ? tr("far from expert")
                        : tr("as a novice");
}

}  // namespace insonate::review
