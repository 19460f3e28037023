#include "FormQuestion.h"

#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QButtonGroup>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::ui {
namespace {

constexpr int kNumber_px = 120, kTextLines = 3;

bool isArrow(int key) {
  return key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_Left || key == Qt::Key_Right;
}

/// Breaks a text between words into lines of at most this width; a button does not wrap its text itself.
QString wrapped(const QString& text, const QFontMetrics& metrics, int width_px) {
  QString lines, line;
  for (const QString& word : text.split(QLatin1Char(' '))) {
    const QString longer = line.isEmpty() ? word : line + QLatin1Char(' ') + word;
    if (!line.isEmpty() && metrics.horizontalAdvance(longer) > width_px) {
      lines += line + QLatin1Char('\n');
      line = word;
    } else {
      line = longer;
    }
  }
  return lines + line;
}

}  // namespace

FormQuestion::FormQuestion(const FormItem& item, bool acceptsNote, QWidget* parent)
    : QWidget(parent),
      name_(item.name),
      noteKey_(insonate::noteKey(item)),
      evidence_(paragraph("", "quiet")),
      error_(paragraph("", "problem")) {
  evidence_->setObjectName(QStringLiteral("evidence_") + qt(name_));
  evidence_->hide();
  error_->setObjectName(QStringLiteral("trouble_") + qt(name_));
  error_->hide();
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kSmallGap);
  auto* head = new QHBoxLayout;
  head->setSpacing(kGap);
  head->addWidget(paragraph("", "", item.needed ? tr("%1 (required)").arg(qt(item.title)) : qt(item.title)), 1);
  box->addLayout(head);
  if (!item.about.empty()) box->addWidget(paragraph("", "quiet", qt(item.about)));
  box->addWidget(item.kind == FormItem::Kind::Choice   ? buildChoice(item)
                 : item.kind == FormItem::Kind::Number ? buildNumber(item)
                                                       : buildText(item));
  if (acceptsNote) {
    buildNote(item);
    head->addWidget(noteButton_, 0, Qt::AlignTop);
    box->addWidget(note_);
  }
  box->addWidget(evidence_);
  box->addWidget(error_);
}

QWidget* FormQuestion::buildChoice(const FormItem& item) {
  auto* room = new QWidget;
  grid_ = new QGridLayout(room);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(kLargeGap);
  grid_->setVerticalSpacing(kSmallGap);
  choice_ = new QButtonGroup(this);
  for (const FormOption& option : item.options) {
    QString title = qt(option.title);
    auto* button = new QRadioButton(title.replace(QLatin1Char('&'), QStringLiteral("&&")));
    button->setObjectName(QStringLiteral("form_%1_%2").arg(qt(name_), qt(option.name)));
    button->setAccessibleName(tr("%1: %2").arg(qt(item.title), qt(option.title)));
    button->setToolTip(tr("Arrow keys choose the answer, Delete clears the answer"));
    button->installEventFilter(this);
    choice_->addButton(button, int(options_.size()));
    options_.push_back(option.name);
    titles_.push_back(button->text());
  }
  // As narrow as one answer; the others wrap below.
  room->setMinimumWidth(1);
  grid_->setColumnStretch(int(options_.size()), 1);
  layOut();
  connect(choice_, &QButtonGroup::idToggled, this, [this](int, bool on) {
    if (on) Q_EMIT changed();
  });
  return room;
}

QWidget* FormQuestion::buildNumber(const FormItem& item) {
  number_ = new QLineEdit;
  number_->setObjectName(QStringLiteral("form_") + qt(name_));
  number_->setAccessibleName(qt(item.title));
  number_->setToolTip(tr("A number from %1 to %2").arg(item.minimum).arg(item.maximum));
  number_->setMaximumWidth(kNumber_px);
  connect(number_, &QLineEdit::textChanged, this, &FormQuestion::changed);
  return number_;
}

QWidget* FormQuestion::buildText(const FormItem& item) {
  text_ = new QPlainTextEdit;
  text_->setObjectName(QStringLiteral("form_") + qt(name_));
  text_->setAccessibleName(qt(item.title));
  text_->setToolTip(tr("Answer in your own words; optional"));
  text_->setTabChangesFocus(true);
  text_->setFixedHeight(kTextLines * fontMetrics().lineSpacing() + 2 * kGap);
  connect(text_, &QPlainTextEdit::textChanged, this, &FormQuestion::changed);
  return text_;
}

/// A line that a button opens.
void FormQuestion::buildNote(const FormItem& item) {
  noteButton_ = new QToolButton;
  noteButton_->setObjectName(QStringLiteral("noteButton_") + qt(name_));
  noteButton_->setText(tr("Note"));
  noteButton_->setAccessibleName(tr("Note to: %1").arg(qt(item.title)));
  noteButton_->setToolTip(tr("Adds a comment on the answer"));
  noteButton_->setCheckable(true);
  noteButton_->setFocusPolicy(Qt::TabFocus);
  note_ = new QLineEdit;
  note_->setObjectName(QStringLiteral("note_") + qt(name_));
  note_->setAccessibleName(noteButton_->accessibleName());
  note_->setToolTip(
      tr("Comment that the trainee sees, and that other raters see after they have submitted their own rating"));
  note_->hide();
  connect(noteButton_, &QToolButton::toggled, note_, &QWidget::setVisible);
  connect(noteButton_, &QToolButton::clicked, note_, [this] {
    if (!note().isEmpty()) noteButton_->setChecked(true);  // existing text is not hidden
    note_->setFocus(Qt::OtherFocusReason);
  });
  connect(note_, &QLineEdit::textChanged, this, &FormQuestion::changed);
}

QString FormQuestion::note() const {
  return note_ ? note_->text().trimmed() : QString();
}

void FormQuestion::setNote(const QString& note) {
  if (!note_) return;
  const QSignalBlocker quiet(this);
  note_->setText(note);
  noteButton_->setChecked(!note.isEmpty());
}

std::optional<FormQuestion::Answer> FormQuestion::answer() const {
  if (choice_) {
    const int option = choice_->checkedId();
    return option < 0 ? std::nullopt : std::optional<Answer>(options_[std::size_t(option)]);
  }
  const QString written = (number_ ? number_->text() : text_->toPlainText()).trimmed();
  if (written.isEmpty()) return std::nullopt;
  bool isNumber = false;
  const double value = number_ ? locale().toDouble(written, &isNumber) : 0;
  // checkAnswers() reports text that is not a number.
  return isNumber ? Answer(value) : Answer(written.toStdString());
}

void FormQuestion::setAnswer(const std::optional<Answer>& answer) {
  const QSignalBlocker quiet(this);
  const auto* words = answer ? std::get_if<std::string>(&*answer) : nullptr;
  const auto* value = answer ? std::get_if<double>(&*answer) : nullptr;
  if (choice_) return choose(words ? int(std::ranges::find(options_, *words) - options_.begin()) : -1);
  const QString text = words ? qt(*words) : value ? locale().toString(*value, 'g', QLocale::FloatingPointShortest) : "";
  number_ ? number_->setText(text) : text_->setPlainText(text);
}

/// An option that does not exist selects none.
void FormQuestion::choose(int option) {
  choice_->setExclusive(false);
  for (QAbstractButton* button : choice_->buttons()) button->setChecked(choice_->id(button) == option);
  choice_->setExclusive(true);
}

void FormQuestion::setEvidence(const QString& answer) {
  evidence_->setText(tr("◆ From the metrics: %1").arg(answer));
  evidence_->setVisible(!answer.isEmpty());
}

void FormQuestion::setError(const QString& sentence) {
  error_->setText(sentence);
  error_->setVisible(!sentence.isEmpty());
}

void FormQuestion::takeKeyboard() {
  QWidget* first = choice_ ? choice_->button(0) : number_ ? static_cast<QWidget*>(number_) : text_;
  if (first) first->setFocus(Qt::OtherFocusReason);
}

bool FormQuestion::eventFilter(QObject* watched, QEvent* event) {
  // Qt gives the focus to the first answer, where Space would overwrite the selected one.
  const auto* focus = event->type() == QEvent::FocusIn ? static_cast<QFocusEvent*>(event) : nullptr;
  const bool comesByTab = focus && (focus->reason() == Qt::TabFocusReason || focus->reason() == Qt::BacktabFocusReason);
  if (QAbstractButton* selected = choice_->checkedButton(); comesByTab && selected && selected != watched) {
    selected->setFocus(focus->reason());
    return true;
  }
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  // Without a selected answer, Qt's arrow keys would only move the focus.
  const bool begins = isArrow(key) && choice_->checkedId() < 0;
  if (key != Qt::Key_Delete && !begins) return QWidget::eventFilter(watched, event);
  choose(begins ? choice_->id(static_cast<QAbstractButton*>(watched)) : -1);
  Q_EMIT changed();
  return true;
}

void FormQuestion::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (grid_) layOut();
}

/// Beside each other if there is room, in columns of equal width; below each other with several lines if one line is
/// too narrow for the longest answer.
void FormQuestion::layOut() {
  const QList<QAbstractButton*> buttons = choice_->buttons();
  int widest_px = 1;
  for (int i = 0; i < buttons.size(); ++i) {
    QStyleOptionButton option;
    option.initFrom(buttons[i]);
    const QSize text = buttons[i]->fontMetrics().size(Qt::TextShowMnemonic, titles_[std::size_t(i)]);
    const int line_px = style()->sizeFromContents(QStyle::CT_RadioButton, &option, text, buttons[i]).width();
    widest_px = std::max(widest_px, line_px);
    const QString shown = line_px <= width() ? titles_[std::size_t(i)]
                                             : wrapped(titles_[std::size_t(i)], buttons[i]->fontMetrics(),
                                                       width() - (line_px - text.width()));
    if (buttons[i]->text() != shown) buttons[i]->setText(shown);
  }
  const int fit = std::max(1, (width() + kLargeGap) / (widest_px + kLargeGap));
  const int columns = std::min(fit, buttons.size());
  if (std::exchange(columns_, columns) == columns) return;
  for (QAbstractButton* button : buttons) grid_->removeWidget(button);
  for (int i = 0; i < buttons.size(); ++i) grid_->addWidget(buttons[i], i / columns, i % columns, Qt::AlignLeft);
}

}  // namespace insonate::ui
