#include "raters/RatersPage.h"

#include "classes/TaughtClass.h"

#include <insonate/curriculum/FormStore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace insonate::web {
namespace {

constexpr const char* kNone = "none";

std::string percentText(const std::optional<double>& share) {
  return share ? std::to_string(std::lround(100 * *share)) + " %" : kNone;
}

std::string coefficientText(const std::optional<double>& value) {
  if (!value) return kNone;
  const double rounded = std::round(*value * 100) / 100;
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.2f", rounded == 0 ? 0 : rounded);  // avoids "-0.00"
  return digits.data();
}

/// A coefficient with its interval, if there is one: "0.62 (0.10 to 0.85)".
std::string coefficientText(const std::optional<Estimate>& value) {
  if (!value) return kNone;
  std::string alone = coefficientText(std::optional(value->value));
  if (!value->interval) return alone;
  return alone + " (" + coefficientText(std::optional(value->interval->low)) + " to " +
         coefficientText(std::optional(value->interval->high)) + ")";
}

/// The forms by which raters judge attempts.
std::vector<Form> judgementForms() {
  std::vector<Form> forms;
  for (const std::string& name : formPresetNames())
    if (auto form = loadForm(name); form && form->isJudgement()) forms.push_back(std::move(*form));
  return forms;
}

Markup choiceForm(const std::string& address, const std::vector<Form>& forms, const Form& chosen) {
  Choices choices;
  for (const Form& form : forms) choices.emplace_back(form.name, form.title);
  return element("form", {{"method", "get"}, {"action", address}, {"class", "line"}},
                 choiceField("Form", "form", choices, chosen.name) + element("button", {{"type", "submit"}}, "Show"));
}

Markup itemsOf(const Form& form, const RaterPair& pair) {
  std::vector<std::vector<Markup>> rows;
  for (const ItemAgreement& one : pair.comparison.items) {
    const FormItem* item = form.item(one.item);
    rows.push_back({text(item ? item->title : one.item), text(std::to_string(one.pairs)),
                    text(percentText(one.agreement)), text(coefficientText(one.kappa)),
                    text(coefficientText(one.points))});
  }
  const std::string title = "Items judged by " + pair.first + " and " + pair.second;
  return element("details", {},
                 element("summary", {}, title) +
                     table(title, {"Item", "Answers", "Equal answers", "Kappa", "ICC of the points"}, rows));
}

Markup agreementMarkup(const Form& form, const FormAgreement& agreement) {
  Markup content = paragraph("Attempts judged by this form: " + std::to_string(agreement.judged) +
                             ". Judged by two or more raters: " + std::to_string(agreement.judgedTwice) + ".");
  if (agreement.otherVersions > 0)
    content += paragraph("Filled forms left out, since they belong to another version of the form: " +
                         std::to_string(agreement.otherVersions) + ".");
  if (agreement.pairs.empty())
    return content + paragraph("There is nothing to compare yet. Judge an attempt that another rater has judged, too.");
  std::vector<std::vector<Markup>> rows;
  Markup items;
  for (const RaterPair& pair : agreement.pairs) {
    const RaterComparison& compared = pair.comparison;
    rows.push_back({text(pair.first + " and " + pair.second), text(std::to_string(pair.attempts)),
                    text(std::to_string(compared.pairs)), text(percentText(compared.agreement)),
                    text(coefficientText(compared.kappa)), text(coefficientText(compared.scores))});
    items += itemsOf(form, pair);
  }
  return content +
         table("Agreement of each pair of raters",
               {"Raters", "Attempts", "Answers", "Equal answers", "Kappa", "ICC of the scores"}, rows) +
         items + note("If you rate attempts by this form, attempts that you have not rated are left out.") +
         note(
             "Kappa (Cohen) is 1 if all answers are equal, and 0 if they are equal as often as by chance. ICC is the "
             "intraclass correlation ICC(2,1) with its 95 % interval.");
}

/// Calls work(class, form, agreement) for the form that the query names, or returns a page that says why it cannot.
template <class Work>
Response withAgreement(const Visit& visit, const Parts& parts, const Work& work) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const std::vector<Form> forms = judgementForms();
    if (forms.empty()) return refusal(visit, 404, "This server has no checklists and ratings.");
    auto form = std::ranges::find(forms, valueOf(visit.request.query, "form"), &Form::name);
    if (form == forms.end()) form = forms.begin();
    const auto agreement = FormStore(*visit.by).agreement(taught.cohort.id, *form);
    return agreement ? work(taught, forms, *form, *agreement) : refusal(visit, 403, agreement.error().message);
  });
}

}  // namespace

Response showRaters(const Visit& visit, const Parts& parts) {
  return withAgreement(
      visit, parts,
      [&](const TaughtClass& taught, const std::vector<Form>& forms, const Form& form, const FormAgreement& agreement) {
        const std::string address = "/classes/" + encoded(taught.cohort.id) + "/raters";
        Markup content = choiceForm(address, forms, form) + agreementMarkup(form, agreement);
        if (!agreement.pairs.empty())
          content +=
              element("form", {{"method", "get"}, {"action", address + "/agreement.csv"}, {"class", "line"}},
                      hiddenField("form", form.name) + element("button", {{"type", "submit"}}, "Save the table (CSV)"));
        return page(visit, "Agreement of raters of " + taught.cohort.name, content);
      });
}

Response exportAgreement(const Visit& visit, const Parts& parts) {
  return withAgreement(visit, parts,
                       [&](const TaughtClass& /*taught*/, const std::vector<Form>& /*forms*/, const Form& form,
                           const FormAgreement& agreement) {
                         return download("raters.csv", "text/csv; charset=utf-8", agreementCsv(form, agreement));
                       });
}

}  // namespace insonate::web
