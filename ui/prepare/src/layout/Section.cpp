#include "Section.h"

#include <insonate/ui/Theme.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace insonate::prepare {

Section::Section(const QString& key, const QString& title, QWidget* content, QWidget* parent)
    : QWidget(parent), key_(key), title_(title), content_(content), heading_(new QToolButton), remark_(new QLabel) {
  heading_->setObjectName(QStringLiteral("section-") + key);
  heading_->setText(title);
  heading_->setCheckable(true);
  heading_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  heading_->setAccessibleName(title);
  heading_->setFocusPolicy(Qt::TabFocus);
  QFont bold = heading_->font();
  bold.setWeight(QFont::DemiBold);
  heading_->setFont(bold);
  heading_->setIconSize({12, 12});
  // Its text is aligned with the content below it.
  heading_->setStyleSheet(QStringLiteral("QToolButton { padding: 4px 4px 4px 0; }"));
  ui::setRole(remark_, "quiet");
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(heading_);
  row->addStretch(1);
  row->addWidget(remark_);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  box->addLayout(row);
  box->addWidget(content_);
  connect(heading_, &QToolButton::clicked, this, [this](bool open) { setOpen(open); });
  setOpen(true);
}

bool Section::isOpen() const {
  return heading_->isChecked();
}

void Section::setOpen(bool open) {
  heading_->setChecked(open);
  heading_->setIcon(ui::icon(open ? QStringLiteral("down") : QStringLiteral("right")));
  heading_->setToolTip(open ? tr("Collapse %1").arg(title_) : tr("Expand %1").arg(title_));
  content_->setVisible(open);
}

void Section::setRemark(const QString& remark) {
  remark_->setText(remark);
}

}  // namespace insonate::prepare
