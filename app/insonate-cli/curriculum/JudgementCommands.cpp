#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"
#include "MetricSeries.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/Form.h>
#include <insonate/curriculum/FormStore.h>

#include <algorithm>
#include <memory>
#include <set>

namespace insonate::cli {
namespace {

struct AgreementArguments {
  std::string form, className, csv;
};

struct CompareArguments {
  std::string form, attempt;
};

Json agreementRow(const RaterPair& pair, const std::string& item, int answers, const std::optional<double>& alike,
                  const std::optional<double>& kappa, const std::optional<Estimate>& icc) {
  const Interval* interval = icc && icc->interval ? &*icc->interval : nullptr;
  return {{"first", pair.first},
          {"second", pair.second},
          {"raters", pair.first + ", " + pair.second},
          {"item", item},
          {"attempts", pair.attempts},
          {"answers", answers},
          {"agreement", orNull(alike)},
          {"kappa", orNull(kappa)},
          {"icc", toJson(icc)},
          {"icc_value", icc ? Json(icc->value) : Json(nullptr)},
          {"icc_low", interval ? Json(interval->low) : Json(nullptr)},
          {"icc_high", interval ? Json(interval->high) : Json(nullptr)}};
}

Result<Answer> agreement(const SignedIn& by, const AgreementArguments& a) {
  const auto form = loadForm(a.form);
  if (!form) return tl::unexpected(form.error());
  const auto cohort = classNamed(by, a.className);
  if (!cohort) return tl::unexpected(cohort.error());
  const auto found = FormStore(by).agreement(cohort->id, *form);
  if (!found) return tl::unexpected(found.error());
  Json rows = Json::array();
  for (const RaterPair& pair : found->pairs) {
    const RaterComparison& all = pair.comparison;
    rows.push_back(agreementRow(pair, "total", all.pairs, all.agreement, all.kappa, all.scores));
    for (const ItemAgreement& one : all.items)
      rows.push_back(agreementRow(pair, one.item, one.pairs, one.agreement, one.kappa, one.points));
  }
  Answer answer{{{"form", form->name},
                 {"form_version", form->version},
                 {"class", cohort->name},
                 {"judged", found->judged},
                 {"judged_twice", found->judgedTwice},
                 {"other_versions", found->otherVersions},
                 {"rows", rows}},
                ""};
  answer.text = std::to_string(found->judged) + " attempts judged by '" + form->name + "', " +
                std::to_string(found->judgedTwice) + " by two raters or more.\n";
  if (found->otherVersions > 0)
    answer.text += "Forms left out, because they have another version: " + std::to_string(found->otherVersions) + ".\n";
  if (rows.empty()) answer.text += "There is nothing to compare, because no attempt was judged by two raters.\n";
  if (!rows.empty())
    answer.text += tableOf(rows, {{"raters", "raters"},
                                  {"item", "item"},
                                  {"attempts", "attempts"},
                                  {"answers", "answers"},
                                  {"agreement", "agreement"},
                                  {"kappa", "kappa"},
                                  {"icc_value", "ICC(2,1)"},
                                  {"icc_low", "95 % from"},
                                  {"icc_high", "to"}});
  if (a.csv.empty()) return answer;
  if (auto written = writeAtomically(a.csv, agreementCsv(*form, *found)); !written)
    return tl::unexpected(written.error());
  answer.object["file"] = a.csv;
  answer.text += "Wrote " + a.csv + ".";
  return answer;
}

/// Item by item, what each rater said, and whether they differ.
Json comparedItems(const Form& form, const std::vector<std::pair<std::string, FormAnswers>>& raters) {
  Json rows = Json::array();
  for (const FormSection& section : form.sections)
    for (const FormItem& item : section.items) {
      Json said = Json::array();
      std::string text;
      std::set<std::string> answers;
      for (const auto& [rater, given] : raters) {
        const std::string answer = answerText(item, given), note = noteText(item, given);
        said.push_back({{"rater", rater}, {"answer", answer}, {"note", note}});
        text += (text.empty() ? "" : " | ") + (answer.empty() ? "n/a" : answer) + (note.empty() ? "" : ": " + note);
        answers.insert(answer);
      }
      rows.push_back({{"item", item.name},
                      {"title", item.title},
                      {"differs", item.kind != FormItem::Kind::Text && answers.size() > 1},
                      {"said", std::move(said)},
                      {"text", text}});
    }
  return rows;
}

Result<Answer> compare(const SignedIn& by, const CompareArguments& a) {
  const auto form = loadForm(a.form);
  if (!form) return tl::unexpected(form.error());
  const auto forms = FormStore(by).listByAttempt(a.attempt);
  if (!forms) return tl::unexpected(forms.error());
  std::vector<std::pair<std::string, FormAnswers>> raters;
  std::string heads;
  int withheld = 0;
  for (const StoredForm& one : *forms) {
    if (one.filled.form != form->name) continue;
    withheld += one.withheld;
    const auto answers = parseAnswers(one.filled.answers);
    if (one.withheld || !answers) continue;
    raters.emplace_back(one.rater, *answers);
    heads += (heads.empty() ? "" : " | ") + one.rater;
  }
  const Json items = raters.empty() ? Json::array() : comparedItems(*form, raters);
  Answer answer{{{"attempt", a.attempt}, {"form", form->name}, {"withheld", withheld}, {"items", items}}, ""};
  if (raters.empty() && withheld == 0)
    answer.text = "No rater has filled in '" + form->name + "' about this attempt yet.\n";
  if (withheld > 0)
    answer.text +=
        "You can read these forms of other raters after you have handed in yours: " + std::to_string(withheld) + ".\n";
  if (!items.empty())
    answer.text += tableOf(items, {{"item", "item"}, {"differs", "differs"}, {"text", heads.c_str()}});
  for (const RaterPair& pair : agreementOf(*form, *forms).pairs)
    answer.text +=
        tableOf(Json::array({agreementRow(pair, "total", pair.comparison.pairs, pair.comparison.agreement,
                                          pair.comparison.kappa, pair.comparison.scores)}),
                {{"raters", "raters"}, {"answers", "answers"}, {"agreement", "agreement"}, {"kappa", "kappa"}});
  return answer;
}

}  // namespace

void addJudgementCommands(CLI::App& forms, Outcome& outcome) {
  auto a = std::make_shared<AgreementArguments>();
  CLI::App* one =
      addSignedInCommand(forms, outcome, "agreement",
                         "Compute how well the raters of a class's attempts agree: in total, and for each item",
                         [a](const SignedIn& by) { return agreement(by, *a); });
  one->add_option("FORM", a->form, "Name")->required();
  one->add_option("CLASS", a->className, "Name of the class")->required();
  one->add_option("--csv", a->csv, "Also write the results to this file")->check(notEmpty());
  auto c = std::make_shared<CompareArguments>();
  CLI::App* two = addSignedInCommand(forms, outcome, "compare",
                                     "Print the raters' answers and notes about one attempt for each item",
                                     [c](const SignedIn& by) { return compare(by, *c); });
  two->add_option("FORM", c->form, "Name")->required();
  two->add_option("ATTEMPT", c->attempt, "Id of the attempt")->required();
}

}  // namespace insonate::cli
