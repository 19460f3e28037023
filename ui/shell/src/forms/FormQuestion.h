#pragma once

#include <insonate/curriculum/Form.h>

#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

class QAbstractButton;
class QButtonGroup;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QToolButton;

namespace insonate::ui {

/// One question of a form, with its answer and an error message about the answer.
class FormQuestion final : public QWidget {
  Q_OBJECT

 public:
  using Answer = FormAnswers::mapped_type;

  /// `acceptsNote`: a button opens a field for a note.
  FormQuestion(const FormItem& item, bool acceptsNote, QWidget* parent = nullptr);

  const std::string& name() const { return name_; }
  /// The answer; empty if there is none.
  std::optional<Answer> answer() const;
  void setAnswer(const std::optional<Answer>& answer);
  /// Key under which the answers hold the note; the note's text is empty if there is none.
  const std::string& noteKey() const { return noteKey_; }
  QString note() const;
  void setNote(const QString& note);
  /// Shows the answer that the recording gives; "" hides it.
  void setEvidence(const QString& answer);
  /// Shows an error message; "" hides it.
  void setError(const QString& sentence);
  void takeKeyboard();

 Q_SIGNALS:
  void changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* buildChoice(const FormItem& item);
  QWidget* buildNumber(const FormItem& item);
  QWidget* buildText(const FormItem& item);
  void buildNote(const FormItem& item);
  void choose(int option);
  void layOut();

  std::string name_, noteKey_;
  std::vector<std::string> options_;
  std::vector<QString> titles_;  ///< texts of the options in one line
  QButtonGroup* choice_ = nullptr;
  QGridLayout* grid_ = nullptr;
  int columns_ = 0;
  QLineEdit* number_ = nullptr;
  QPlainTextEdit* text_ = nullptr;
  QToolButton* noteButton_ = nullptr;
  QLineEdit* note_ = nullptr;
  QLabel *evidence_, *error_;
};

}  // namespace insonate::ui
