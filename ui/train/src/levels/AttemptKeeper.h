#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/AttemptSeal.h>

#include <QFuture>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <optional>
#include <string>

namespace insonate {
struct Curriculum;
struct Level;
}  // namespace insonate

namespace insonate::ui {
class Account;
}

namespace insonate::train {

class AttemptControl;

/// Level of an attempt; null for free practice.
struct AttemptAim {
  const Curriculum* curriculum = nullptr;
  const Level* level = nullptr;
};

/// Facts that could not be stored on this computer; empty if they were.
using KeptFacts = QFuture<std::optional<AttemptFacts>>;

/// Stores each attempt of the signed-in user, at its beginning and its end, with the facts of its recording, of which
/// the store keeps a copy. Facts are first written on this computer, so that nothing is lost while the store cannot be
/// reached; waiting facts are sent once a minute, when a server is back and when their person signs in. Signing out
/// ends an attempt as abandoned. Attempts of guests are not stored. Requests the seal of the next attempt's recording
/// beforehand, so that it begins at once, also while a server is unreachable. For the window's thread; waits for
/// nothing.
class AttemptKeeper final : public QObject {
  Q_OBJECT

 public:
  AttemptKeeper(AttemptControl& attempt, QString folder, QObject* parent = nullptr);

  void setAccount(ui::Account& account);
  /// Sets the function that is asked for the aim as an attempt begins.
  void setAim(std::function<AttemptAim()> aim) { aim_ = std::move(aim); }
  /// Prepares the next attempt after a change of the aim.
  void prepare();

 Q_SIGNALS:
  /// Reports the end of an attempt of the signed-in user; the facts go to the store next.
  void ended(const insonate::AttemptFacts& facts);
  /// The store has all facts of the signed-in user.
  void allSent();
  /// Sentence about facts that could not be sent.
  void said(const QString& sentence);

 private:
  /// A seal for the next attempt, of this person and aim.
  struct Sealed {
    AttemptFacts facts{};
    AttemptSeal seal{};
  };
  bool isKept() const;
  AttemptFacts nextFacts() const;
  void start();
  void takeSeal(Result<Sealed> sealed);
  void begin();
  void end();
  void keep(const AttemptFacts& facts, const QString& recording);
  void send(const std::optional<KeptFacts>& fresh);
  void tell(const Result<std::string>& sent, bool isFresh);

  AttemptControl& attempt_;
  ui::Account* account_ = nullptr;
  const QString folder_;
  std::function<AttemptAim()> aim_;
  std::optional<AttemptFacts> facts_;  ///< of the attempt that runs
  std::optional<Sealed> next_;
  std::string starter_;     ///< who started the attempt that starts or runs; "": a guest
  bool isAwaited_ = false;  ///< the seal, by an attempt that starts
  std::string trouble_;     ///< as last said
  QTimer again_;
};

}  // namespace insonate::train
