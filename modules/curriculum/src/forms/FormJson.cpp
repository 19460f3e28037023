#include "rules/PlainName.h"

#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>
#include <insonate/curriculum/Form.h>
#include <insonate/embedded/forms.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <set>

namespace insonate {
namespace {

using nlohmann::json;

/// In the order of Form::Purpose and FormItem::Kind.
const std::vector<std::string_view> kPurposes{"questionnaire", "checklist", "rating", "debrief"};
/// In the order of FormEvidence::Proof.
const std::vector<std::string_view> kProofs{"both", "done", "not done"};
const std::vector<std::string_view> kKinds{"choice", "number", "text"};

/// Options that items share, by name.
using OptionSets = std::map<std::string, std::vector<FormOption>, std::less<>>;

FormOption readOption(const json& object, const std::string& where, std::string& error) {
  JsonEntry entry(object, where, {"name", "title", "points"}, error);
  FormOption option{entry.text("name"), entry.text("title"), entry.optionalNumber("points", -1000, 1000)};
  return option;
}

void readScale(const json& object, const std::string& where, std::string& error, OptionSets& sets) {
  JsonEntry entry(object, where, {"name", "options"}, error);
  const std::string name = entry.text("name");
  sets[name] = entry.list("options", where + ", option", readOption);
}

void readChoice(JsonEntry& entry, FormItem& item, const OptionSets& sets) {
  if (entry.has("scale") == entry.has("options")) return entry.setError("needs one of 'scale' and 'options'.");
  std::vector<std::string_view> names;
  for (const auto& [name, options] : sets) names.push_back(name);
  if (entry.has("scale")) {
    const std::size_t chosen = entry.word("scale", names);
    if (entry.error().empty()) item.options = sets.find(names[chosen])->second;
  } else {
    item.options = entry.list("options", entry.where() + ", option", readOption);
  }
  if (item.options.size() < 2) entry.setError("offers fewer than two options to choose from.");
}

FormEvidence readEvidence(const json& object, const std::string& where, std::string& error) {
  constexpr double kAny = std::numeric_limits<float>::max();
  JsonEntry entry(object, where + ", from,", {"metric", "least", "most", "proves", "after"}, error);
  FormEvidence evidence{entry.text("metric"), entry.optionalNumber("least", -kAny, kAny),
                        entry.optionalNumber("most", -kAny, kAny)};
  if (entry.has("proves")) evidence.proof = static_cast<FormEvidence::Proof>(entry.word("proves", kProofs));
  evidence.after = entry.text("after", false);
  if (!evidence.least && !evidence.most) entry.setError("needs 'least' or 'most'.");
  return evidence;
}

FormItem readItem(const json& object, const std::string& where, std::string& error, const OptionSets& sets) {
  constexpr double kAny = std::numeric_limits<float>::max();
  JsonEntry entry(object, where,
                  {"name", "title", "about", "kind", "needed", "scale", "options", "least", "most", "from"}, error);
  FormItem item;
  item.name = entry.text("name"), item.title = entry.text("title"), item.about = entry.text("about", false);
  if (!item.name.empty() && !isPlainName(item.name)) entry.setError(kPlainNameSentence);
  item.kind = static_cast<FormItem::Kind>(entry.word("kind", kKinds));
  item.needed = entry.flag("needed");
  if (item.kind == FormItem::Kind::Choice) readChoice(entry, item, sets);
  if (item.kind == FormItem::Kind::Number)
    item.minimum = entry.number("least", -kAny, kAny), item.maximum = entry.number("most", item.minimum, kAny);
  if (entry.has("from")) {
    if (item.kind != FormItem::Kind::Choice) entry.setError("has 'from', which goes with the kind 'choice'.");
    item.evidence = readEvidence(entry.value("from"), where, error);
  }
  return item;
}

FormSection readSection(const json& object, const std::string& where, std::string& error, const OptionSets& sets) {
  JsonEntry entry(object, where, {"title", "about", "items"}, error);
  FormSection section{entry.text("title"), entry.text("about", false), {}};
  section.items = entry.list("items", "item", [&](const json& item, const std::string& at, std::string& wrong) {
    return readItem(item, at, wrong, sets);
  });
  return section;
}

/// Names of items are unique in a form.
void refuseTwins(JsonEntry& file, const Form& form) {
  std::set<std::string_view> names;
  for (const FormSection& section : form.sections)
    for (const FormItem& item : section.items)
      if (!names.insert(item.name).second)
        return file.setError("cannot be used: item '" + item.name + "' occurs twice. Give each a different name.");
  if (names.empty()) file.setError("asks nothing; list at least one item in one of its 'sections'.");
}

}  // namespace

std::vector<std::string> formPresetNames() {
  return presetNames(embeddedPresets(embedded::forms::files()));
}

Result<Form> parseForm(std::string_view text) {
  const auto object = parsedJson(text, "The form");
  if (!object) return tl::unexpected(object.error());
  JsonEntry file(*object, "The form", {"name", "title", "about", "source", "version", "purpose", "scales", "sections"});
  Form form;
  form.name = file.text("name"), form.title = file.text("title");
  if (!form.name.empty() && !isPlainName(form.name)) file.setError(kPlainNameSentence);
  form.about = file.text("about", false), form.source = file.text("source", false);
  form.version = file.integer("version", 1, 1'000'000);
  form.purpose = static_cast<Form::Purpose>(file.word("purpose", kPurposes));
  OptionSets sets;
  file.list("scales", "scale", [&](const json& scale, const std::string& where, std::string& error) {
    readScale(scale, where, error, sets);
    return 0;
  });
  form.sections =
      file.list("sections", "section", [&](const json& section, const std::string& where, std::string& error) {
        return readSection(section, where, error, sets);
      });
  refuseTwins(file, form);
  if (!file.error().empty()) return fail(file.error());
  return form;
}

Result<Form> loadForm(std::string_view nameOrPath) {
  return presetOrFile("a form", nameOrPath, embeddedPresets(embedded::forms::files()), parseForm);
}

}  // namespace insonate
