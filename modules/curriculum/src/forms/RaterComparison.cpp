#include <insonate/curriculum/Agreement.h>
#include <insonate/curriculum/RaterComparison.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace insonate {
namespace {

/// Options with points, by rising points.
std::vector<FormOption> gradesOf(const FormItem& item) {
  std::vector<FormOption> grades;
  std::ranges::copy_if(item.options, std::back_inserter(grades),
                       [](const FormOption& o) { return o.points.has_value(); });
  std::ranges::stable_sort(grades, {}, [](const FormOption& option) { return *option.points; });
  return grades;
}

std::optional<int> gradeOf(const FormItem& item, const std::vector<FormOption>& grades, const FormAnswers& answers) {
  const auto answer = answers.find(item.name);
  const auto* name = answer == answers.end() ? nullptr : std::get_if<std::string>(&answer->second);
  const auto found = name ? std::ranges::find(grades, *name, &FormOption::name) : grades.end();
  return found == grades.end() ? std::nullopt : std::optional(static_cast<int>(found - grades.begin()));
}

/// Pairs of both raters' grades of one item, one for each attempt that both graded.
struct ItemPairs {
  const FormItem* item = nullptr;
  std::vector<FormOption> scale{};
  bool hasPoints = true;  ///< false: the options have no points, and the scale is all options in the form's order
  std::vector<int> first{}, second{};
};

std::vector<ItemPairs> pairsOf(const Form& form, std::span<const RatingPair> attempts) {
  std::vector<ItemPairs> all;
  for (const FormSection& section : form.sections)
    for (const FormItem& item : section.items) {
      ItemPairs pairs{&item, gradesOf(item)};
      if (pairs.scale.empty()) pairs.scale = item.options, pairs.hasPoints = false;
      if (pairs.scale.empty()) continue;
      for (const RatingPair& attempt : attempts) {
        const auto one = gradeOf(item, pairs.scale, attempt.first), other = gradeOf(item, pairs.scale, attempt.second);
        if (!one || !other) continue;
        pairs.first.push_back(*one), pairs.second.push_back(*other);
      }
      all.push_back(std::move(pairs));
    }
  return all;
}

/// Answers without points have no distances from each other that weights could express.
std::optional<double> kappaOf(std::span<const int> first, std::span<const int> second, std::size_t grades,
                              bool hasPoints = true) {
  return cohenKappa(first, second, static_cast<int>(grades),
                    hasPoints && grades > 2 ? KappaWeights::Quadratic : KappaWeights::None);
}

ItemAgreement agreementOf(const ItemPairs& pairs) {
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; pairs.hasPoints && i < pairs.first.size(); ++i) {
    const auto pointsOf = [&](int grade) { return *pairs.scale[static_cast<std::size_t>(grade)].points; };
    points.push_back({pointsOf(pairs.first[i]), pointsOf(pairs.second[i])});
  }
  return {pairs.item->name, static_cast<int>(pairs.first.size()), agreement(pairs.first, pairs.second),
          kappaOf(pairs.first, pairs.second, pairs.scale.size(), pairs.hasPoints), intraclassCorrelation(points)};
}

std::vector<std::string> maxFrequentFirst(const std::vector<std::pair<std::string, int>>& counts) {
  auto sorted = counts;
  std::ranges::stable_sort(sorted, std::ranges::greater(), &std::pair<std::string, int>::second);
  std::vector<std::string> names;
  for (const auto& [name, count] : sorted)
    if (count > 0) names.push_back(name);
  return names;
}

std::optional<Estimate> agreementOfScores(const Form& form, std::span<const RatingPair> attempts) {
  std::vector<std::vector<double>> scores;
  for (const RatingPair& attempt : attempts) {
    const auto first = formScore(form, attempt.first).percent, second = formScore(form, attempt.second).percent;
    if (first && second) scores.push_back({*first, *second});
  }
  return intraclassCorrelation(scores);
}

}  // namespace

RaterComparison compareRaters(const Form& form, std::span<const RatingPair> attempts) {
  const std::vector<ItemPairs> all = pairsOf(form, attempts);
  std::size_t grades = 0;
  for (const ItemPairs& pairs : all)
    if (pairs.hasPoints) grades = std::max(grades, pairs.scale.size());
  RaterComparison comparison;
  std::vector<int> first, second;
  std::vector<std::pair<std::string, int>> differing;
  for (const ItemPairs& pairs : all) {
    comparison.items.push_back(agreementOf(pairs));
    if (!pairs.hasPoints || pairs.scale.size() < grades) continue;
    first.insert(first.end(), pairs.first.begin(), pairs.first.end());
    second.insert(second.end(), pairs.second.begin(), pairs.second.end());
    differing.emplace_back(pairs.item->name, 0);
    for (std::size_t i = 0; i < pairs.first.size(); ++i) differing.back().second += pairs.first[i] != pairs.second[i];
  }
  comparison.pairs = static_cast<int>(first.size());
  comparison.agreement = agreement(first, second);
  comparison.kappa = kappaOf(first, second, grades);
  comparison.scores = agreementOfScores(form, attempts);
  comparison.differing = maxFrequentFirst(differing);
  return comparison;
}

}  // namespace insonate
