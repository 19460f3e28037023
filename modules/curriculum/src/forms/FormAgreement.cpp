#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/FormAgreement.h>

#include <algorithm>
#include <map>
#include <utility>

namespace insonate {
namespace {

/// Name of a rater, with the id if two raters have the same name.
using Rater = std::pair<std::string, std::string>;
/// Each rater's answers about each attempt, by the attempt's id.
using Judgements = std::map<std::string, std::map<Rater, FormAnswers>>;

bool isJudgement(const Form& form, const StoredForm& one) {
  return one.filled.form == form.name && !one.filled.attempt.empty() && one.filled.by != one.filled.person &&
         !one.withheld;
}

std::vector<RaterPair> pairsOf(const Form& form, const Judgements& judgements) {
  std::map<std::pair<Rater, Rater>, std::vector<RatingPair>> twice;
  for (const auto& [attempt, raters] : judgements)
    for (auto first = raters.begin(); first != raters.end(); ++first)
      for (auto second = std::next(first); second != raters.end(); ++second)
        twice[{first->first, second->first}].push_back({first->second, second->second});
  std::vector<RaterPair> pairs;
  for (const auto& [raters, rated] : twice)
    pairs.push_back(
        {raters.first.first, raters.second.first, static_cast<int>(rated.size()), compareRaters(form, rated)});
  return pairs;
}

}  // namespace

FormAgreement agreementOf(const Form& form, std::span<const StoredForm> forms) {
  FormAgreement result;
  Judgements judgements;
  for (const StoredForm& one : forms) {
    if (!isJudgement(form, one)) continue;
    if (one.filled.formVersion != form.version) {
      ++result.otherVersions;
      continue;
    }
    // Answers that cannot be parsed were stored by another program and are ignored.
    if (auto answers = parseAnswers(one.filled.answers))
      judgements[one.filled.attempt].try_emplace({one.rater, one.filled.by}, std::move(*answers));
  }
  result.judged = static_cast<int>(judgements.size());
  result.judgedTwice =
      static_cast<int>(std::ranges::count_if(judgements, [](const auto& one) { return one.second.size() > 1; }));
  result.pairs = pairsOf(form, judgements);
  return result;
}

std::string agreementCsv(const Form& form, const FormAgreement& agreement) {
  std::vector<std::vector<std::string>> rows{{"form", "version", "first rater", "second rater", "item", "title",
                                              "attempts", "answers", "agreement", "kappa", "icc", "icc from",
                                              "icc to"}};
  const auto add = [&](const RaterPair& pair, const std::string& item, const std::string& title, int answers,
                       const std::optional<double>& alike, const std::optional<double>& kappa,
                       const std::optional<Estimate>& icc) {
    const Interval* interval = icc && icc->interval ? &*icc->interval : nullptr;
    rows.push_back({form.name, std::to_string(form.version), pair.first, pair.second, item, title,
                    std::to_string(pair.attempts), std::to_string(answers), csvNumber(alike), csvNumber(kappa),
                    csvNumber(icc ? std::optional(icc->value) : std::nullopt),
                    csvNumber(interval ? std::optional(interval->low) : std::nullopt),
                    csvNumber(interval ? std::optional(interval->high) : std::nullopt)});
  };
  for (const RaterPair& pair : agreement.pairs) {
    const RaterComparison& all = pair.comparison;
    add(pair, "total", form.title, all.pairs, all.agreement, all.kappa, all.scores);
    for (const ItemAgreement& one : all.items) {
      const FormItem* item = form.item(one.item);
      add(pair, one.item, item ? item->title : "", one.pairs, one.agreement, one.kappa, one.points);
    }
  }
  return csvText(rows);
}

}  // namespace insonate
