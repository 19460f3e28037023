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

/// Items with the most grades that any of the form has.
std::vector<const FormItem*> gradedItems(const Form& form, std::size_t& grades) {
  std::vector<const FormItem*> items;
  for (const FormSection& section : form.sections)
    for (const FormItem& item : section.items) {
      const std::size_t own = gradesOf(item).size();
      if (own > grades) grades = own, items.clear();
      if (own == grades && own > 0) items.push_back(&item);
    }
  return items;
}

std::vector<std::string> mostFrequentFirst(const std::vector<std::pair<std::string, int>>& counts) {
  auto sorted = counts;
  std::ranges::stable_sort(sorted, std::ranges::greater(), &std::pair<std::string, int>::second);
  std::vector<std::string> names;
  for (const auto& [name, count] : sorted)
    if (count > 0) names.push_back(name);
  return names;
}

std::optional<Estimate> agreementOfScores(const Form& form, std::span<const RatedTwice> attempts) {
  std::vector<std::vector<double>> scores;
  for (const RatedTwice& attempt : attempts) {
    const auto first = formScore(form, attempt.first).percent, second = formScore(form, attempt.second).percent;
    if (first && second) scores.push_back({*first, *second});
  }
  return intraclassCorrelation(scores);
}

}  // namespace

RaterComparison compareRaters(const Form& form, std::span<const RatedTwice> attempts) {
  std::size_t grades = 0;
  std::vector<int> first, second;
  std::vector<std::pair<std::string, int>> differing;
  for (const FormItem* item : gradedItems(form, grades)) {
    const std::vector<FormOption> scale = gradesOf(*item);
    differing.emplace_back(item->name, 0);
    for (const RatedTwice& attempt : attempts) {
      const auto one = gradeOf(*item, scale, attempt.first), other = gradeOf(*item, scale, attempt.second);
      if (!one || !other) continue;
      first.push_back(*one), second.push_back(*other);
      differing.back().second += *one != *other;
    }
  }
  RaterComparison comparison;
  comparison.pairs = static_cast<int>(first.size());
  comparison.agreement = agreement(first, second);
  comparison.kappa =
      cohenKappa(first, second, static_cast<int>(grades), grades > 2 ? KappaWeights::Quadratic : KappaWeights::None);
  comparison.scores = agreementOfScores(form, attempts);
  comparison.differing = mostFrequentFirst(differing);
  return comparison;
}

}  // namespace insonate
