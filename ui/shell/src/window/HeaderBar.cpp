#include "HeaderBar.h"

#include "AccountMenu.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/Theme.h>

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

namespace insonate::ui {
namespace {

constexpr int kMaxName_px = 180;

QToolButton* menuButton(QMenu* menu, const char* iconName, const QString& text, const QString& name) {
  auto* button = new QToolButton;
  button->setText(QLatin1Char(' ') + text);
  button->setAccessibleName(name);
  button->setIcon(icon(QLatin1String(iconName)));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setMenu(menu);
  // A click must leave the keyboard to the image.
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

HeaderBar::HeaderBar(QMenu* viewMenu, QMenu* caseMenu, AccountMenu* accountMenu, Commands& commands, QWidget* parent)
    : QFrame(parent), tabs_(new QButtonGroup(this)), tabRow_(new QHBoxLayout), case_(new QLabel) {
  setRole(this, "header");
  auto* product = new QLabel(QStringLiteral("Insonate"));
  setRole(product, "product");
  case_->setTextFormat(Qt::PlainText);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kLargeGap, 0, kGap, 0);
  row->setSpacing(kLargeGap);
  tabRow_->setSpacing(0);
  row->addWidget(product);
  row->addSpacing(kGap);
  row->addLayout(tabRow_);
  // Shortened, so that it does not widen the window.
  case_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  case_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(case_, 1);
  auto* view = menuButton(viewMenu, "view", tr("View"), tr("View menu"));
  auto* cases = menuButton(caseMenu, "folder", tr("Case"), tr("Case menu"));
  auto* who = menuButton(accountMenu, "person", accountMenu->shortText(), tr("Account menu"));
  for (QToolButton* button : {view, cases, who}) row->addWidget(button);
  commands.add(QStringLiteral("window.menu.view"), tr("opens the menu of panels and views"), *view,
               QKeySequence(QStringLiteral("Alt+V")));
  commands.add(QStringLiteral("window.menu.case"), tr("opens the menu to open, import and save cases"), *cases,
               QKeySequence(QStringLiteral("Alt+C")));
  commands.add(QStringLiteral("window.menu.account"), tr("opens the menu of the account: sign in, sign out, password"),
               *who, QKeySequence(QStringLiteral("Alt+U")));
  connect(accountMenu, &AccountMenu::textChanged, who, [who, accountMenu] {
    const QKeySequence keys = who->shortcut();
    const QString text = who->fontMetrics().elidedText(accountMenu->shortText(), Qt::ElideRight, kMaxName_px);
    who->setText(QLatin1Char(' ') + plainCaption(text));
    who->setShortcut(keys);  // setting a text removes the shortcut
  });
  connect(tabs_, &QButtonGroup::idClicked, this, &HeaderBar::tabChosen);
}

void HeaderBar::addTab(const QString& title, const QString& iconName, const QString& tip) {
  auto* tab = new QToolButton;
  setRole(tab, "tab");
  tab->setText(QLatin1Char(' ') + title);
  tab->setAccessibleName(title);
  tab->setIcon(icon(iconName));
  tab->setIconSize({20, 20});
  tab->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  tab->setCheckable(true);
  tab->setFocusPolicy(Qt::StrongFocus);
  tab->setToolTip(tip);
  tabs_->addButton(tab, tabs_->buttons().size());
  tabRow_->addWidget(tab);
}

void HeaderBar::setTab(int index) {
  if (QAbstractButton* tab = tabs_->button(index)) tab->setChecked(true);
}

void HeaderBar::setCaseTitle(const QString& title, const QString& hint) {
  title_ = title.isEmpty() ? tr("no case") : title;
  case_->setToolTip(plainToolTip(hint.isEmpty() ? title_ : title_ + QLatin1Char('\n') + hint));
  case_->setAccessibleName(title_);
  elide();
}

QString HeaderBar::caseTitle() const {
  return title_;
}

void HeaderBar::elide() {
  case_->setText(case_->fontMetrics().elidedText(title_, Qt::ElideMiddle, std::max(0, case_->width())));
}

void HeaderBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  // Its own width is known after the next layout.
  layout()->activate();
  elide();
}

}  // namespace insonate::ui
