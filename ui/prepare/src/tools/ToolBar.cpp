#include "ToolBar.h"

#include "ToolSession.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/Theme.h>

#include <QAction>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

namespace insonate::prepare {

ToolBar::ToolBar(ToolSession& tools, const ui::Commands& commands) : tools_(tools) {
  setObjectName(QStringLiteral("toolBar"));
  auto* box = new QHBoxLayout(this);
  box->setContentsMargins(ui::kSmallGap, ui::kSmallGap, ui::kSmallGap, ui::kSmallGap);
  box->setSpacing(0);
  QToolButton* look = add({}, tr("No tool"),
                          tr("Deselects the tool; the left mouse button then moves the crosshair (%1)")
                              .arg(commands.find(QStringLiteral("prepare.tools.leave"))->listed));
  connect(look, &QToolButton::clicked, this, [this] { tools_.choose({}); });
  entries_.push_back({look, {}});
  for (const Tool& tool : toolTable()) {
    const QString keys = QKeySequence(tool.key).toString();
    const bool alone = tool.group.isEmpty();
    const QString name = alone ? tool.name : tool.group;
    auto found = std::ranges::find_if(entries_, [&](const Entry& e) { return e.button->accessibleName() == name; });
    if (found == entries_.end()) {
      QToolButton* made =
          add(alone ? tool.id : tool.group.toLower(), name, QStringLiteral("%1 (%2)").arg(tool.advice, keys));
      found = entries_.insert(found, {made, {}});
      if (!alone) {
        made->setMenu(new QMenu(made));
        made->menu()->setToolTipsVisible(true);
        made->setPopupMode(QToolButton::InstantPopup);
        // Qt does not notify a button whose menu has grabbed the mouse that the pointer has left.
        connect(made->menu(), &QMenu::aboutToHide, made, [made] {
          made->setAttribute(Qt::WA_UnderMouse, false);
          made->update();
        });
      }
    }
    found->ids << tool.id;
    QToolButton* button = found->button;
    if (alone) {
      connect(button, &QToolButton::clicked, this, [this, id = tool.id] { tools_.choose(id); });
      continue;
    }
    QAction* action = button->menu()->addAction(tool.name, this, [this, id = tool.id] { tools_.choose(id); });
    action->setObjectName(QStringLiteral("tool-") + tool.id);
    action->setToolTip(tool.advice);
    QStringList names;
    for (const QAction* one : button->menu()->actions()) names << one->text();
    button->setToolTip(
        tr("%1 (%2; press again for the next tool): %3").arg(name, keys, names.join(QStringLiteral(", "))));
  }
  box->addStretch(1);
  connect(&tools_, &ToolSession::toolChanged, this, [this] { refresh(); });
  refresh();
}

QToolButton* ToolBar::add(const QString& id, const QString& name, const QString& tip) {
  auto* button = new QToolButton;
  ui::setRole(button, "palette");
  button->setObjectName(QStringLiteral("tool-") + (id.isEmpty() ? QStringLiteral("none") : id));
  button->setIcon(ui::icon(id.isEmpty() ? QStringLiteral("view") : QStringLiteral("tool-") + id));
  button->setIconSize({20, 20});
  button->setText(name);
  button->setAccessibleName(name);
  button->setToolTip(tip);
  button->setCheckable(true);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setFocusPolicy(Qt::TabFocus);
  static_cast<QHBoxLayout*>(layout())->addWidget(button);
  return button;
}

/// A truncated name is not readable; the tooltip has the whole name.
void ToolBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  int words_px = 2 * ui::kSmallGap;
  for (const Entry& entry : entries_) {
    entry.button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    words_px += entry.button->sizeHint().width();
  }
  if (words_px <= width()) return;
  for (const Entry& entry : entries_) entry.button->setToolButtonStyle(Qt::ToolButtonIconOnly);
}

void ToolBar::refresh() {
  const QString id = tools_.tool() ? tools_.tool()->id : QString();
  for (const Entry& entry : entries_)
    entry.button->setChecked(id.isEmpty() ? entry.ids.isEmpty() : entry.ids.contains(id));
}

QString toolOfKey(int key, const QString& inHand) {
  QStringList ids;
  for (const Tool& tool : toolTable())
    if (tool.key == key) ids << tool.id;
  if (ids.isEmpty()) return {};
  return ids[(ids.indexOf(inHand) + 1) % ids.size()];
}

}  // namespace insonate::prepare
