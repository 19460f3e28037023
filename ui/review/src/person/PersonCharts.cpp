#include "PersonCharts.h"

#include "../class/ClassWords.h"

#include <insonate/curriculum/Comparison.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/Statistics.h>
#include <insonate/curriculum/Unlocking.h>
#include <insonate/teaching/MetricComparison.h>
#include <insonate/ui/Text.h>

#include <algorithm>

namespace insonate::review {
namespace {

/// Norms of the procedure that all attempts share; none if there are several procedures.
MetricMeaning sharedMeaning(const std::vector<const AttemptFacts*>& attempts, const MetricMeaning& meaning) {
  if (attempts.empty()) return meaning;
  const std::string& procedure = attempts.front()->procedure;
  const bool same = std::ranges::all_of(attempts, [&](const AttemptFacts* one) { return one->procedure == procedure; });
  return same ? MetricCatalog::instance().withNormsOf(procedure, meaning) : meaning;
}

/// Rank among the others of the class; equal values do not count as worse.
QString placeWords(const std::vector<double>& all, double own, const MetricMeaning& meaning) {
  if (meaning.better == MetricMeaning::Better::Neither)
    return tr("percentile %1 in the class").arg(*percentileRank(all, own), 0, 'f', 0);
  const PlaceInClass place = placeAmong(all, own, meaning);
  const auto percentOf = [&](int people) { return QString::number(100.0 * people / place.others, 'f', 0); };
  if (place.equal == place.others) return tr("equal to all others in the class");
  const QString better = tr("better than %1 % of the others").arg(percentOf(place.worse));
  return place.equal == 0 ? better : tr("%1, equal to %2 % of them").arg(better, percentOf(place.equal));
}

/// Title of the axis that numbers a person's attempts.
QString attemptAxis(const std::string& level) {
  return level.empty() ? tr("attempt number, all levels and free practice") : tr("attempt number, this level");
}

}  // namespace

std::vector<const AttemptFacts*> attemptsAt(const PersonFacts& facts, const std::string& level) {
  const auto isOf = [&](const AttemptFacts& one) {
    const Level* at = facts.curriculum && one.level == level ? levelOf(*facts.curriculum, one) : nullptr;
    return at && !countsAsPractice(one, *at);
  };
  std::vector<const AttemptFacts*> attempts;
  for (const AttemptFacts& one : facts.history)
    if (isInFigures(one) && (level.empty() || isOf(one))) attempts.push_back(&one);
  return attempts;
}

ui::ChartContents learningOf(const PersonFacts& facts, const std::string& level, const MetricMeaning& meaning) {
  const auto attempts = attemptsAt(facts, level);
  std::vector<std::optional<double>> values;
  for (const AttemptFacts* one : attempts) values.push_back(valueIn(*one, meaning));
  auto picture = ui::learningChart(sharedMeaning(attempts, meaning), values);
  picture.xTitle = attemptAxis(level);
  return picture;
}

ui::ChartContents cusumOf(const PersonFacts& facts, const std::string& level) {
  const Level* known = facts.curriculum ? facts.curriculum->level(level) : nullptr;
  if (!known) {
    ui::ChartContents picture;
    picture.title = tr("LC-CUSUM");
    picture.words = facts.curriculum ? tr("n/a: choose a level above; the LC-CUSUM is shown for one level.")
                                     : tr("n/a: the class has no curriculum; only a curriculum defines a pass.");
    return picture;
  }
  if (!known->mastery.cusum) {
    ui::ChartContents picture;
    picture.title = tr("LC-CUSUM");
    const int passes = known->mastery.consecutivePasses;
    picture.words =
        passes == 1
            ? tr("n/a: this level does not use the LC-CUSUM; the level is mastered after one passed attempt.")
            : tr("n/a: this level does not use the LC-CUSUM; the level is mastered after %1 passed attempts in a row.")
                  .arg(passes);
    return picture;
  }
  std::vector<bool> passes;
  for (const AttemptFacts* one : attemptsAt(facts, level))
    if (isCounted(*one, *known)) passes.push_back(judge(known->pass, *one).passed);
  auto picture = ui::cusumChart(passes, *known->mastery.cusum);
  picture.title = tr("LC-CUSUM: mastery needs at least %1 attempts").arg(fewestAttempts(known->mastery));
  picture.xTitle = attemptAxis(level);
  return picture;
}

ui::ChartContents placeInClass(const PersonFacts& facts, const HeatMap& heat, const MetricMeaning& meaning) {
  ui::ChartContents picture;
  picture.title = tr("Compared with the class");
  picture.xTitle = tr("last %1 attempts at levels").arg(kLastAttempts);
  picture.yTitle = titleWithUnit(meaning);
  const auto& all = MetricCatalog::instance().all();
  const auto column = std::size_t(std::ranges::find(all, meaning.id, &MetricMeaning::id) - all.begin());
  const std::vector<double> means = valuesOf(heat, column);
  const auto row = heat.find(facts.person.id);
  const auto own = row == heat.end() ? std::nullopt : row->second[column].value;
  if (heat.empty() || !own || means.size() < kFewestCompared) {
    picture.words = heat.empty() ? tr("n/a: the person is in no class, or you are no instructor of the class.")
                    : !own ? tr("n/a: no data in the last %1 attempts of this person at levels.").arg(kLastAttempts)
                           : tr("n/a: fewer than %1 people of the class have data.").arg(kFewestCompared);
    return picture;
  }
  picture.boxes.push_back({0, *boxPlotOf(means), ui::ChartContents::Tone::Quiet});
  picture.categories = QStringList{tr("class, n = %1").arg(means.size())};
  picture.lines.push_back(
      {placeWords(means, *own, meaning), {{0, *own}}, ui::ChartContents::Tone::Caution, Qt::NoPen, true});
  return picture;
}

}  // namespace insonate::review
