#pragma once

#include <insonate/core/Result.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace insonate {

struct FormOption {
  std::string name{};              ///< as it is stored
  std::string title{};             ///< as it is read
  std::optional<double> points{};  ///< none: is not scored, as "not seen"

  bool operator==(const FormOption&) const = default;
};

/// One question.
struct FormItem {
  enum class Kind { Choice, Number, Text };

  std::string name{};  ///< unique in its form
  std::string title{};
  std::string about{};  ///< what a rater looks for; may be empty
  Kind kind = Kind::Choice;
  bool needed = false;
  std::vector<FormOption> options{};  ///< of a choice, in their order; a scale's points grow or fall with it
  double least = 0, most = 0;         ///< of a number

  bool operator==(const FormItem&) const = default;
};

struct FormSection {
  std::string title{}, about{};
  std::vector<FormItem> items{};

  bool operator==(const FormSection&) const = default;
};

/// A questionnaire, a checklist or a rating scale, as data.
struct Form {
  enum class Purpose {
    Questionnaire,  ///< by the trainee, about the simulator
    Checklist,      ///< by a rater, about an attempt: what was done
    Rating,         ///< by a rater, about an attempt: how well
  };

  std::string name{}, title{}, about{};
  std::string source{};  ///< on whose work its structure stands
  int version = 1;
  Purpose purpose = Purpose::Questionnaire;
  std::vector<FormSection> sections{};

  const FormItem* item(std::string_view itemName) const;
  /// Tells whether a rater may write a note to this item: in checklists and ratings, unless the answer is text anyway.
  bool takesNote(const FormItem& item) const {
    return purpose != Purpose::Questionnaire && item.kind != FormItem::Kind::Text;
  }
  bool operator==(const Form&) const = default;
};

/// The presets of resources/forms.
std::vector<std::string> formPresetNames();
/// A preset's name or a JSON file of the same form. Fails with a sentence on where and what.
Result<Form> loadForm(std::string_view nameOrPath);
Result<Form> parseForm(std::string_view json);

/// Answers by FormItem::name (an option's name, a text or a number) and by noteKey() (a text). Unanswered items are
/// missing.
using FormAnswers = std::map<std::string, std::variant<std::string, double>>;

/// Key under which a rater's note on an item is stored; no item has such a name.
std::string noteKey(const FormItem& item);
/// An answer as readers see it: an option's title, a number or a text; "" without an answer.
std::string answerText(const FormItem& item, const FormAnswers& answers);
std::string noteText(const FormItem& item, const FormAnswers& answers);

/// JSON object, as FilledForm::answers.
Result<FormAnswers> parseAnswers(std::string_view json);
std::string answersText(const FormAnswers& answers);

struct AnswerTrouble {
  std::string item{};      ///< FormItem::name, or an answer's that has none
  std::string sentence{};  ///< what is wrong and what to do
};

/// Everything that keeps these answers from being stored, in the form's order; empty: they are fine.
std::vector<AnswerTrouble> checkAnswers(const Form& form, const FormAnswers& answers);

struct FormScore {
  double points = 0, most = 0;      ///< of items that were answered with an option that has points
  std::optional<double> percent{};  ///< 100 points / most; none where nothing is scored
  int scored = 0;                   ///< items
  int unscored = 0;                 ///< items with points that were not answered, or by an option without
};

/// Answers that are not fine are left out. Most are the points of an item's best option.
FormScore formScore(const Form& form, const FormAnswers& answers);

}  // namespace insonate
