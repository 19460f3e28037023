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

/// Writes each attempt of who is signed in into the store, as it begins and as it ends, by what its recording tells, of
/// which the store keeps a copy. It is first written down on this computer, so that nothing is lost where the store
/// cannot be reached; what waits is sent again once a minute, when a server is back and when its person signs in. Who
/// signs out leaves their attempt, which is kept as abandoned. Of guests nothing is kept. Asks the store for the seal
/// of the next attempt's recording beforehand, so that it begins at once, also while a server is away. For the window's
/// thread, which waits for nothing.
class AttemptKeeper final : public QObject {
  Q_OBJECT

 public:
  AttemptKeeper(AttemptControl& attempt, QString folder, QObject* parent = nullptr);

  void setAccount(ui::Account& account);
  /// Asked as an attempt begins.
  void setAim(std::function<AttemptAim()> aim) { aim_ = std::move(aim); }
  /// After the aim has become another one.
  void prepare();

 Q_SIGNALS:
  /// An attempt of who is signed in ended; the store hears of it next.
  void ended(const insonate::AttemptFacts& facts);
  /// The store has all that there is of who is signed in.
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
