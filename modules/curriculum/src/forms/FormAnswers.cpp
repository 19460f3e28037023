#include <insonate/core/JsonEntry.h>
#include <insonate/core/Words.h>
#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/Form.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestText = 10'000;
/// Suffix of the key of a note; names of items contain no colon.
constexpr std::string_view kNote = ":note";

const FormOption* optionOf(const FormItem& item, const FormAnswers::mapped_type& answer) {
  const auto* name = std::get_if<std::string>(&answer);
  const auto found = name ? std::ranges::find(item.options, *name, &FormOption::name) : item.options.end();
  return found == item.options.end() ? nullptr : &*found;
}

std::string errorOfNumber(const FormItem& item, const FormAnswers::mapped_type& answer) {
  const auto* number = std::get_if<double>(&answer);
  if (number && *number >= item.minimum && *number <= item.maximum) return {};
  return "needs a number from " + csvNumber(item.minimum) + " to " + csvNumber(item.maximum) + ".";
}

std::string errorOfText(const FormAnswers::mapped_type& answer) {
  const auto* text = std::get_if<std::string>(&answer);
  if (!text) return "needs a text.";
  if (text->find('\0') != std::string::npos) return "contains a zero byte, which is invisible. Type the text again.";
  return text->size() <= kLongestText ? "" : "is too long; shorten it to " + std::to_string(kLongestText) + " bytes.";
}

std::string errorOfChoice(const FormItem& item, const FormAnswers::mapped_type& answer) {
  if (optionOf(item, answer)) return {};
  std::vector<std::string_view> names;
  for (const FormOption& option : item.options) names.push_back(option.name);
  return "needs one of " + joinedWords(names) + ".";
}

/// Describes the error in an item's answer, after the item's title; empty if there is none.
std::string problemOf(const FormItem& item, const FormAnswers& answers) {
  const auto answer = answers.find(item.name);
  if (answer == answers.end()) return item.needed ? "needs an answer." : "";
  if (item.kind == FormItem::Kind::Number) return errorOfNumber(item, answer->second);
  return item.kind == FormItem::Kind::Text ? errorOfText(answer->second) : errorOfChoice(item, answer->second);
}

std::optional<double> valueOf(const std::vector<MetricFact>& metrics, std::string_view id) {
  const auto fact = std::ranges::find(metrics, id, &MetricFact::id);
  return fact == metrics.end() ? std::nullopt : fact->value;
}

/// The answer that a value of the metric gives; null if it gives none.
const FormOption* optionFor(const FormItem& item, double value) {
  const FormEvidence& evidence = *item.evidence;
  const bool isDone = value >= evidence.least.value_or(value) && value <= evidence.most.value_or(value);
  if (evidence.proof == (isDone ? FormEvidence::Proof::NotDone : FormEvidence::Proof::Done)) return nullptr;
  const FormOption* chosen = nullptr;
  for (const FormOption& option : item.options) {
    if (!option.points) continue;
    if (!chosen || (isDone ? *option.points > *chosen->points : *option.points < *chosen->points)) chosen = &option;
  }
  return chosen;
}

/// Tells whether a key that belongs to no item is the key of a permitted note.
bool isNote(const Form& form, std::string_view key) {
  if (!key.ends_with(kNote)) return false;
  const FormItem* item = form.item(key.substr(0, key.size() - kNote.size()));
  return item && form.acceptsNote(*item);
}

/// Points of the best option; none for items that are not scored.
std::optional<double> maxOf(const FormItem& item) {
  std::optional<double> most;
  for (const FormOption& option : item.options)
    if (option.points) most = std::max(most.value_or(*option.points), *option.points);
  return most;
}

}  // namespace

const FormItem* Form::item(std::string_view itemName) const {
  for (const FormSection& section : sections)
    for (const FormItem& item : section.items)
      if (item.name == itemName) return &item;
  return nullptr;
}

std::string noteKey(const FormItem& item) {
  return item.name + std::string(kNote);
}

std::string answerText(const FormItem& item, const FormAnswers& answers) {
  const auto answer = answers.find(item.name);
  if (answer == answers.end()) return {};
  if (const auto* number = std::get_if<double>(&answer->second)) return csvNumber(*number);
  const FormOption* option = optionOf(item, answer->second);
  return option ? option->title : std::get<std::string>(answer->second);
}

std::string noteText(const FormItem& item, const FormAnswers& answers) {
  const auto note = answers.find(noteKey(item));
  const auto* text = note == answers.end() ? nullptr : std::get_if<std::string>(&note->second);
  return text ? *text : std::string();
}

FormAnswers answersFrom(const Form& form, const std::vector<MetricFact>& metrics) {
  FormAnswers answers;
  for (const FormSection& section : form.sections)
    for (const FormItem& item : section.items) {
      if (!item.evidence) continue;
      const auto value = valueOf(metrics, item.evidence->metric);
      if (!value || (!item.evidence->after.empty() && valueOf(metrics, item.evidence->after).value_or(0) <= 0))
        continue;
      if (const FormOption* option = optionFor(item, *value)) answers.emplace(item.name, option->name);
    }
  return answers;
}

Result<FormAnswers> parseAnswers(std::string_view text) {
  const auto object = parsedJson(text, "The text of the answers");
  if (!object) return tl::unexpected(object.error());
  if (!object->is_object()) return fail("The answers must be an object { ... } of texts and numbers.");
  FormAnswers answers;
  for (const auto& [name, value] : object->items()) {
    if (value.is_string())
      answers.emplace(name, value.get<std::string>());
    else if (value.is_number())
      answers.emplace(name, value.get<double>());
    else
      return fail("The answer '" + name + "' must be a text or a number.");
  }
  return answers;
}

std::string answersText(const FormAnswers& answers) {
  json object = json::object();
  for (const auto& [name, answer] : answers)
    std::visit([&entry = object[name]](const auto& value) { entry = value; }, answer);
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::vector<AnswerError> checkAnswers(const Form& form, const FormAnswers& answers) {
  std::vector<AnswerError> errors;
  for (const FormSection& section : form.sections)
    for (const FormItem& item : section.items)
      if (const std::string error = problemOf(item, answers); !error.empty())
        errors.push_back({item.name, "'" + item.title + "' " + error});
  for (const auto& [name, answer] : answers) {
    if (form.item(name)) continue;
    if (!isNote(form, name))
      errors.push_back({name, "'" + name + "' is not an item of '" + form.title + "'; leave it out."});
    else if (const std::string error = errorOfText(answer); !error.empty())
      errors.push_back({name, "The note '" + name + "' " + error});
  }
  return errors;
}

FormScore formScore(const Form& form, const FormAnswers& answers) {
  FormScore score;
  for (const FormSection& section : form.sections)
    for (const FormItem& item : section.items) {
      const auto most = maxOf(item);
      if (!most) continue;
      const auto answer = answers.find(item.name);
      const FormOption* option = answer == answers.end() ? nullptr : optionOf(item, answer->second);
      if (!option || !option->points) {
        ++score.unscored;
        continue;
      }
      ++score.scored;
      score.points += *option->points, score.maxPoints += *most;
    }
  if (score.maxPoints > 0) score.percent = 100 * score.points / score.maxPoints;
  return score;
}

}  // namespace insonate
