#include <insonate/ui/Commands.h>
#include <insonate/ui/ViewKeys.h>

#include <QAbstractButton>
#include <QAction>
#include <QKeyEvent>
#include <QKeySequence>
#include <algorithm>
#include <utility>

namespace insonate::ui {
namespace {

constexpr Qt::KeyboardModifiers kDistinguishing = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;

bool haveSameKeys(const Command& a, const Command& b) {
  return std::ranges::any_of(a.keys, [&b](const CommandKey& one) {
    return std::ranges::any_of(
        b.keys, [&one](const CommandKey& other) { return one.key == other.key && one.modifiers == other.modifiers; });
  });
}

QString firstUpper(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

void Commands::beginSection(const QString& heading) {
  const auto known = std::ranges::find(sections_, heading, &ShortcutGroup::place);
  section_ = std::size_t(known - sections_.begin());
  if (known == sections_.end()) sections_.push_back({heading, {}});
}

void Commands::add(Command command) {
  Q_ASSERT_X(!find(command.id), "Commands::add", "the id is in use");
  Q_ASSERT_X(std::ranges::none_of(commands_, [&](const Command& one) { return haveSameKeys(one, command); }),
             "Commands::add", "a key is in use");
  if (!command.listed.isEmpty()) addListed(command.listed, command.does);
  commands_.push_back(std::move(command));
}

void Commands::addListed(const QString& keys, const QString& does) {
  if (sections_.empty()) sections_.emplace_back();
  sections_[section_].shortcuts.push_back({keys, does});
}

void Commands::add(const QString& id, const QString& does, QAction& action) {
  const QPointer<QAction> self = &action;
  add({.id = id,
       .text = action.text(),
       .does = does,
       .listed = action.shortcut().toString(QKeySequence::NativeText),
       .keys = {},
       .perform =
           [self](KeyPress) {
             if (self) self->trigger();
           },
       .isAvailable = [self] { return self && self->isEnabled() && self->isVisible(); }});
  action.setToolTip(toolTip(id));
  actions_[id] = &action;
}

void Commands::add(const QString& id, const QString& does, QAbstractButton& button, const QKeySequence& key) {
  const QPointer<QAbstractButton> self = &button;
  add({.id = id,
       .text = button.text().trimmed(),
       .does = does,
       .listed = key.toString(QKeySequence::NativeText),
       .keys = {},
       .perform =
           [self](KeyPress) {
             if (self) self->click();
           },
       .isAvailable = [self] { return self && self->isEnabled() && self->isVisible(); }});
  button.setShortcut(key);
  button.setToolTip(toolTip(id));
}

const Command* Commands::commandOf(const QKeyEvent& event, const CommandKey*& key) const {
  const Qt::KeyboardModifiers modifiers = event.modifiers() & kDistinguishing;
  for (const Command& command : commands_)
    for (const CommandKey& one : command.keys)
      if (one.key == event.key() && one.modifiers == modifiers) {
        key = &one;
        return &command;
      }
  return nullptr;
}

bool Commands::key(const QKeyEvent& event, bool isPerformed) const {
  const CommandKey* key = nullptr;
  const Command* command = commandOf(event, key);
  if (!command || (command->isAvailable && !command->isAvailable())) return false;
  if (isPerformed)
    (key->perform ? key->perform
                  : command->perform)({event.modifiers().testFlag(Qt::ShiftModifier), event.isAutoRepeat()});
  return true;
}

bool Commands::handleKeyEvent(QEvent& event) const {
  return handleViewKey(event, [this](const QKeyEvent& pressed, bool isPerformed) { return key(pressed, isPerformed); });
}

const Command* Commands::find(const QString& id) const {
  const auto found = std::ranges::find(commands_, id, &Command::id);
  return found == commands_.end() ? nullptr : &*found;
}

QString Commands::toolTip(const QString& id) const {
  const Command* command = find(id);
  return command ? toolTip(firstUpper(command->does), id) : QString();
}

QString Commands::toolTip(const QString& sentence, const QString& id) const {
  const Command* command = find(id);
  return !command || command->listed.isEmpty() ? sentence : QStringLiteral("%1 (%2)").arg(sentence, command->listed);
}

QAction* Commands::action(const QString& id) {
  if (const auto known = actions_.find(id); known != actions_.end()) return known->second;
  const Command* command = find(id);
  if (!command) return nullptr;
  const QString key = command->keys.empty()
                          ? QString()
                          : QKeySequence(int(command->keys.front().modifiers) | command->keys.front().key)
                                .toString(QKeySequence::NativeText);
  // A menu shows the text behind a tab where it shows shortcuts.
  auto* action = new QAction(key.isEmpty() ? command->text : command->text + QLatin1Char('\t') + key, this);
  action->setObjectName(id);
  actions_[id] = action;
  action->setToolTip(toolTip(id));
  connect(action, &QAction::triggered, this, [this, id] {
    const Command& triggered = *find(id);
    if (!triggered.isAvailable || triggered.isAvailable()) triggered.perform({});
  });
  return action;
}

std::vector<ShortcutGroup> Commands::shortcuts() const {
  std::vector<ShortcutGroup> filled;
  std::ranges::copy_if(sections_, std::back_inserter(filled),
                       [](const ShortcutGroup& one) { return !one.shortcuts.empty(); });
  return filled;
}

}  // namespace insonate::ui
