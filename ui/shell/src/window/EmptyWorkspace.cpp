#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/Theme.h>

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace insonate::ui {
namespace {

constexpr int kColumn_px = 520;

}  // namespace

EmptyWorkspace::EmptyWorkspace(const Words& words, QWidget* parent)
    : Workspace(parent), words_(words), column_(new QVBoxLayout), title_(new QLabel(words.title)) {
  auto* sign = new QLabel;
  sign->setPixmap(icon(words.icon, views::theme::kQuiet).pixmap(40, 40));
  setRole(title_, "title");
  column_->setSpacing(kLargeGap);
  column_->addWidget(sign);
  column_->addWidget(title_);
  for (const QString& paragraph : words.paragraphs) {
    auto* text = new QLabel(paragraph);
    text->setWordWrap(true);
    text->setFixedWidth(kColumn_px);
    column_->addWidget(text);
  }
  auto* middle = new QVBoxLayout(this);
  middle->addStretch(2);
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  row->addLayout(column_);
  row->addStretch(1);
  middle->addLayout(row);
  middle->addStretch(3);
}

void EmptyWorkspace::showOpening(const QString& what) {
  title_->setText(what.isEmpty() ? words_.title : tr("%1 ...").arg(what));
}

void EmptyWorkspace::addOpenAction(QAction* action) {
  auto* button = new QPushButton(action->icon(), action->text());
  button->setToolTip(action->toolTip());
  if (!offered_) setRole(button, "primary");
  if (!offered_) button->setIcon({});
  offered_ = true;
  connect(button, &QPushButton::clicked, action, &QAction::trigger);
  column_->addWidget(button, 0, Qt::AlignLeft);
}

}  // namespace insonate::ui
