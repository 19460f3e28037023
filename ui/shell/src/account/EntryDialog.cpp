#include "EntryDialog.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::ui {
namespace {

constexpr int kText_px = 380;

QLabel* wideParagraph(const QString& text) {
  auto* label = paragraph("", "", text);
  label->setMinimumWidth(kText_px);
  return label;
}

}  // namespace

EntryDialog::EntryDialog(const QString& title, const QString& explanation, const std::vector<Entry>& entries,
                         const QString& button, Action action, QWidget* parent)
    : QDialog(parent),
      error_(wideParagraph({})),
      go_(new QPushButton(button)),
      buttons_(new QHBoxLayout),
      action_(std::move(action)) {
  setWindowTitle(title);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* heading = new QLabel(title);
  setRole(heading, "title");
  auto* about = wideParagraph(explanation);
  setRole(about, "quiet");
  auto* form = new QFormLayout;
  form->setVerticalSpacing(kGap);
  for (const Entry& entry : entries) {
    fields_.push_back(fieldOf(entry));
    form->addRow(entry.label, fields_.back());
  }
  error_->setObjectName(QStringLiteral("entryTrouble"));
  error_->hide();
  go_->setObjectName(QStringLiteral("entryGo"));
  go_->setToolTip(tr("%1 (Enter)").arg(button));
  go_->setDefault(true);
  setRole(go_, "primary");
  auto* leave = new QPushButton(tr("Cancel"));
  leave->setToolTip(tr("Closes this dialog without changes (Esc)"));
  leave->setAutoDefault(false);
  connect(go_, &QPushButton::clicked, this, &EntryDialog::act);
  connect(leave, &QPushButton::clicked, this, &QDialog::reject);

  buttons_->setSpacing(kGap);
  buttons_->addStretch();
  buttons_->addWidget(leave);
  buttons_->addWidget(go_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  column->setSpacing(kLargeGap);
  column->addWidget(heading);
  column->addWidget(about);
  column->addLayout(form);
  column->addWidget(error_);
  column->addLayout(buttons_);
  // Gives the focus to the first empty field.
  for (QWidget* field : fields_)
    if (auto* line = qobject_cast<QLineEdit*>(field); line && line->text().isEmpty()) {
      line->setFocus();
      break;
    }
}

void EntryDialog::offer(const char* name, const QString& text, const QString& tip, std::function<void()> instead) {
  buttons_->insertWidget(0, addOffer(name, text, tip, std::move(instead)));
}

void EntryDialog::offerAsDefault(const char* name, const QString& text, const QString& tip,
                                 std::function<void()> instead) {
  QPushButton* other = addOffer(name, text, tip, std::move(instead));
  buttons_->addWidget(other);
  go_->setAutoDefault(false);
  go_->setDefault(false);
  go_->setToolTip(go_->text());
  setRole(go_, "");
  setRole(other, "primary");
  other->setDefault(true);
  other->setFocus();
}

QPushButton* EntryDialog::addOffer(const char* name, const QString& text, const QString& tip,
                                   std::function<void()> instead) {
  auto* other = new QPushButton(text);
  other->setObjectName(QLatin1String(name));
  other->setToolTip(tip);
  other->setAutoDefault(false);
  connect(other, &QPushButton::clicked, this, [this, instead = std::move(instead)] {
    reject();
    instead();
  });
  return other;
}

QWidget* EntryDialog::fieldOf(const Entry& entry) {
  QWidget* field = nullptr;
  if (entry.choices.isEmpty()) {
    auto* line = new QLineEdit(entry.text);
    if (entry.secret) line->setEchoMode(QLineEdit::Password);
    field = line;
  } else {
    auto* choice = new QComboBox;
    choice->addItems(entry.choices);
    choice->setCurrentText(entry.text);
    field = choice;
  }
  field->setObjectName(QLatin1String(entry.name));
  field->setAccessibleName(entry.label);
  field->setToolTip(entry.tip);
  return field;
}

void EntryDialog::act() {
  if (!go_->isEnabled()) return;
  go_->setEnabled(false);
  error_->hide();
  QStringList texts;
  for (const QWidget* field : fields_) {
    const auto* line = qobject_cast<const QLineEdit*>(field);
    texts << (line ? line->text() : static_cast<const QComboBox*>(field)->currentText());
  }
  action_(texts, [dialog = QPointer<EntryDialog>(this)](const Result<void>& result) {
    if (dialog) result ? dialog->accept() : dialog->refuse(QString::fromStdString(result.error().message));
  });
}

void EntryDialog::refuse(const QString& why) {
  go_->setEnabled(true);
  error_->setText(QStringLiteral("▲  ") + why);
  error_->show();
  layout()->activate();
  resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
  // The next text of the user must not go into the password while the name is missing.
  auto* first = fields_.empty() ? nullptr : qobject_cast<QLineEdit*>(fields_.front());
  if (first && first->text().trimmed().isEmpty()) return first->setFocus();
  for (QWidget* field : fields_)
    if (auto* line = qobject_cast<QLineEdit*>(field); line && line->echoMode() == QLineEdit::Password) {
      line->setFocus();
      line->selectAll();
      break;
    }
}

}  // namespace insonate::ui
