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
  std::string name{};              ///< name under which the answer is stored
  std::string title{};             ///< text shown to the user
  std::optional<double> points{};  ///< empty: the option is not scored, e.g. "not seen"

  bool operator==(const FormOption&) const = default;
};

/// A question of a form.
struct FormItem {
  enum class Kind { Choice, Number, Text };

  std::string name{};  ///< unique within the form
  std::string title{};
  std::string about{};  ///< hint for the rater; may be empty
  Kind kind = Kind::Choice;
  bool needed = false;
  /// Options of a choice, in order; on a scale the points rise or fall in this order.
  std::vector<FormOption> options{};
  double least = 0, most = 0;  ///< limits of a number

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
    Questionnaire,  ///< filled in by the trainee, about the simulator
    Checklist,      ///< filled in by a rater, about an attempt: which steps were done
    Rating,         ///< filled in by a rater, about an attempt: how well it was done
  };

  std::string name{}, title{}, about{};
  std::string source{};  ///< publication on which the form's structure is based
  int version = 1;
  Purpose purpose = Purpose::Questionnaire;
  std::vector<FormSection> sections{};

  const FormItem* item(std::string_view itemName) const;
  /// Tells whether a rater may write a note on this item: in checklists and ratings, unless the answer is itself a
  /// text.
  bool takesNote(const FormItem& item) const {
    return purpose != Purpose::Questionnaire && item.kind != FormItem::Kind::Text;
  }
  bool operator==(const Form&) const = default;
};

/// Names of the presets of resources/forms.
std::vector<std::string> formPresetNames();
/// Loads a preset by name, or a JSON file of the same form. Fails with a sentence that names the place and the error.
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

/// Reads answers from a JSON object as in FilledForm::answers.
Result<FormAnswers> parseAnswers(std::string_view json);
std::string answersText(const FormAnswers& answers);

struct AnswerTrouble {
  std::string item{};      ///< FormItem::name, or the name of an answer to which no item belongs
  std::string sentence{};  ///< explains the error and what to do
};

/// Returns every reason why these answers cannot be stored, in the form's order; empty if they are valid.
std::vector<AnswerTrouble> checkAnswers(const Form& form, const FormAnswers& answers);

struct FormScore {
  double points = 0, most = 0;      ///< sums over items that were answered with an option that has points
  std::optional<double> percent{};  ///< 100 points / most; empty if nothing is scored
  int scored = 0;                   ///< number of scored items
  /// Number of items with points that were not answered, or were answered with an option without points.
  int unscored = 0;
};

/// Computes the score. Invalid answers are left out. `most` counts the points of each item's best option.
FormScore formScore(const Form& form, const FormAnswers& answers);

}  // namespace insonate
