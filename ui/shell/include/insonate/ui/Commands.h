#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <map>
#include <vector>

class QAbstractButton;
class QAction;
class QEvent;
class QKeyEvent;
class QKeySequence;

namespace insonate::ui {

/// A key or a mouse gesture as the list of keys (`?`) shows it.
struct Shortcut {
  QString keys;  ///< as printed on the keyboard, e.g. "Shift + arrows"
  QString does;  ///< e.g. "tilt and rock the probe"
};

/// Shortcuts of one place in the window, under a common heading.
struct ShortcutGroup {
  QString place;
  std::vector<Shortcut> shortcuts;
};

/// Modifiers of a key press.
struct KeyPress {
  bool wide = false;      ///< Shift was held
  bool repeated = false;  ///< sent repeatedly by a key that is held down
};

/// One key of a command. Shift selects the wide step of the same key.
struct CommandKey {
  int key = 0;                                      ///< Qt::Key
  Qt::KeyboardModifiers modifiers{};                ///< Ctrl and Alt that must be held
  std::function<void(KeyPress)> perform = nullptr;  ///< null: Command::perform
};

/// Something that the user can do with a key, and with a menu entry or a button if action() or toolTip() is used.
struct Command {
  QString id;      ///< "workspace.feature.act", e.g. "train.image.freeze"; unique
  QString text;    ///< for menus, e.g. "Freeze image"; may be empty for a command without a menu entry
  QString does;    ///< for tooltips and the list of keys, e.g. "freezes the image, or continues with live images"
  QString listed;  ///< keys as listed for the user, e.g. "Arrows"; empty: not listed
  std::vector<CommandKey> keys;
  std::function<void(KeyPress)> perform;        ///< for keys without a function of their own, and for action()
  std::function<bool()> isAvailable = nullptr;  ///< null: always
};

/// All commands of one workspace. Keys, menu entries, tooltips and the list of keys are made from it. Features add
/// their commands when they are constructed. For the window's thread only.
class Commands : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Begins a section of the list of keys; commands and gestures that follow belong to it. A heading that was used
  /// before continues its section.
  void beginSection(const QString& heading);
  /// Adds a command. Its id and its keys must not be in use.
  void add(Command command);
  /// Adds a command of a Qt action with the action's text. The action handles its keys: the first one is listed, if it
  /// has one. Sets the action's tooltip.
  void add(const QString& id, const QString& does, QAction& action);
  /// Adds a command of a button with the button's text. The button gets this key, handles it, and gets a tooltip.
  void add(const QString& id, const QString& does, QAbstractButton& button, const QKeySequence& key);
  /// Adds a key that a Qt action or a widget handles itself, or a mouse gesture, to the list of keys.
  void addListed(const QString& keys, const QString& does);

  /// Performs the available command of a key. @returns whether there is one; if not `isPerformed`, nothing else happens
  bool key(const QKeyEvent& event, bool isPerformed) const;
  /// Handles a key event of a canvas whose keys take precedence over the window's shortcuts. @returns whether the event
  /// is consumed
  bool offer(QEvent& event) const;

  /// The command with this id; null if there is none.
  const Command* find(const QString& id) const;
  /// Sentence about a command with its keys, for the tooltip of its button; empty if there is no such command.
  QString toolTip(const QString& id) const;
  /// Another sentence with the keys of a command, for a button that the command presses in some states only.
  QString toolTip(const QString& sentence, const QString& id) const;
  /// Menu entry that performs a command: the action with which the command was added, else an action that is made at
  /// the first call and owned by this object; null if there is no such command. An action that is made here shows the
  /// first key as text only: key() handles it.
  QAction* action(const QString& id);

  /// The list of keys, by section; sections without entries are left out.
  std::vector<ShortcutGroup> shortcuts() const;
  const std::vector<Command>& all() const { return commands_; }

 private:
  const Command* commandOf(const QKeyEvent& event, const CommandKey*& key) const;

  std::vector<Command> commands_;
  std::vector<ShortcutGroup> sections_;
  std::map<QString, QPointer<QAction>> actions_;
  std::size_t section_ = 0;  ///< the section that is being filled
};

}  // namespace insonate::ui
