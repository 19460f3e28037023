#include "LinkTime.h"
#include "Sockets.h"

#include <insonate/igtlink/LinkParser.h>
#include <insonate/igtlink/LinkServer.h>

#include <poll.h>

#include <algorithm>
#include <array>
#include <deque>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>

namespace insonate {
namespace {

using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;

/// Replies on their way from the threads that answer commands to the server's thread.
struct ReplyBox {
  struct Reply {
    std::uint64_t client = 0;
    Bytes message;
  };
  std::mutex mutex;  ///< guards replies
  std::vector<Reply> replies;
  WakeUp wakeUp;
};

/// A program that is connected; used by the server's thread.
struct LinkPeer {
  LinkPeer(Descriptor accepted, std::uint64_t id) : connection(std::move(accepted)), number(id) {}

  Descriptor connection;
  std::uint64_t number = 0;
  LinkParser parser{{"STRING"}};
  int openCommands = 0;
  std::deque<Bytes> replies;
  Bytes sending;  ///< message that is being sent, and the bytes sent of it
  std::size_t sent = 0;
  bool sendingFrame = false;
  std::uint64_t frame = 0;  ///< number of the last frame that was begun
  bool closed = false;
};

/// "ACK_13" for "CMD_13"; empty if the device name is not that of a command.
std::string replyDevice(const std::string& device) {
  constexpr std::string_view kCommand = "CMD";
  if (device != kCommand && !device.starts_with("CMD_")) return {};
  return "ACK" + device.substr(kCommand.size());
}

}  // namespace

class LinkServer::Impl {
 public:
  Impl(Descriptor listening, CommandHandler handler)
      : listening_(std::move(listening)),
        port_(portOf(listening_)),
        handler_(std::move(handler)),
        thread_([this](const std::stop_token& stop) { run(stop); }) {}
  ~Impl() {
    thread_.request_stop();
    box_->wakeUp.wake();
  }

  void post(std::shared_ptr<const LinkFrame> frame) {
    {
      const std::scoped_lock lock(mutex_);
      latest_.swap(frame);
      ++status_.posted;
    }
    box_->wakeUp.wake();
  }
  int port() const { return port_; }
  LinkServerStatus status() const {
    const std::scoped_lock lock(mutex_);
    return status_;
  }

 private:
  void run(const std::stop_token& stop) {
    std::vector<pollfd> waiting;
    while (!stop.stop_requested()) {
      waiting.clear();
      waiting.push_back({box_->wakeUp.get(), POLLIN, 0});
      waiting.push_back({listening_.get(), POLLIN, 0});
      for (const LinkPeer& peer : peers_) waiting.push_back({peer.connection.get(), eventsOf(peer), 0});
      poll(waiting.data(), waiting.size(), -1);
      box_->wakeUp.reset();
      takeReplies();
      const std::uint64_t posted = status().posted;
      for (std::size_t i = 0; i < peers_.size(); ++i) {
        if ((waiting[i + 2].revents & (POLLIN | POLLHUP | POLLERR)) != 0) receive(peers_[i]);
        sendAll(peers_[i], posted);
      }
      std::erase_if(peers_, [](const LinkPeer& peer) { return peer.closed; });
      if (waiting[1].revents != 0) acceptAll(posted);
      const std::scoped_lock lock(mutex_);
      status_.clients = static_cast<int>(peers_.size());
    }
  }

  static short eventsOf(const LinkPeer& peer) {
    return static_cast<short>((peer.openCommands < kMaxOpenCommands ? POLLIN : 0) | (peer.sending ? POLLOUT : 0));
  }

  void acceptAll(std::uint64_t posted) {
    while (auto connection = acceptFrom(listening_)) {
      if (peers_.size() >= kMaxClients) {
        setLastError("More than " + std::to_string(kMaxClients) + " programs tried to connect.");
        continue;
      }
      peers_.emplace_back(std::move(*connection), ++lastPeer_);
      sendAll(peers_.back(), posted);
    }
  }

  void receive(LinkPeer& peer) {
    std::array<std::uint8_t, 16 * 1024> buffer;
    // Two blocks at most, so that a client that sends without end does not hold up the others.
    for (int block = 0; block < 2 && !peer.closed; ++block) {
      const auto [size, closed] = receiveFrom(peer.connection, buffer);
      peer.closed = closed;
      if (size == 0) return;
      const auto ok = peer.parser.feed({buffer.data(), size}, [&](LinkMessage&& message) { obey(peer, message); });
      if (ok) continue;
      peer.closed = true;
      setLastError(ok.error().message);
    }
  }

  void obey(LinkPeer& peer, const LinkMessage& message) {
    const std::string device = replyDevice(message.device);
    const auto text = textOf(message);
    if (device.empty() || !text) return;
    {
      const std::scoped_lock lock(mutex_);
      ++status_.commands;
    }
    ++peer.openCommands;
    const Answer answer = [box = box_, client = peer.number, device](const LinkReply& reply) {
      auto bytes = std::make_shared<std::vector<std::uint8_t>>();
      appendString(*bytes, device, replyText(reply), timeSince1970_ns());
      {
        const std::scoped_lock lock(box->mutex);
        box->replies.push_back({client, std::move(bytes)});
      }
      box->wakeUp.wake();
    };
    const auto command = parsedCommand(*text);
    if (!command)
      answer({false, command.error().message, {}});
    else if (!handler_)
      answer({false, "This server takes no commands.", {}});
    else
      handler_(*command, answer);
  }

  void takeReplies() {
    std::vector<ReplyBox::Reply> replies;
    {
      const std::scoped_lock lock(box_->mutex);
      replies.swap(box_->replies);
    }
    for (ReplyBox::Reply& reply : replies)
      for (LinkPeer& peer : peers_)
        if (peer.number == reply.client) peer.replies.push_back(std::move(reply.message));
  }

  /// Sends until the connection takes no more bytes, or until the client has the latest frame.
  void sendAll(LinkPeer& peer, std::uint64_t posted) {
    while (!peer.closed && chooseMessage(peer, posted)) {
      const auto rest = std::span<const std::uint8_t>(*peer.sending).subspan(peer.sent);
      const auto [size, closed] = sendTo(peer.connection, rest);
      peer.closed = closed;
      peer.sent += size;
      if (size < rest.size()) return;
      finishMessage(peer);
    }
  }

  bool chooseMessage(LinkPeer& peer, std::uint64_t posted) {
    if (peer.sending) return true;
    if (!peer.replies.empty()) {
      peer.sending = std::move(peer.replies.front());
      peer.replies.pop_front();
      peer.sendingFrame = false;
    } else if (peer.frame < posted) {
      peer.sending = latestBytes(posted);
      peer.frame = encoded_;
      peer.sendingFrame = true;
    }
    return peer.sending != nullptr;
  }

  void finishMessage(LinkPeer& peer) {
    peer.sending = nullptr;
    peer.sent = 0;
    if (!peer.sendingFrame) {
      --peer.openCommands;
      return;
    }
    const std::scoped_lock lock(mutex_);
    ++status_.sent;
  }

  /// The messages of the latest frame, which all clients share. Encoded here, so that post() takes no time.
  Bytes latestBytes(std::uint64_t posted) {
    if (encoded_ >= posted) return latestBytes_;
    std::shared_ptr<const LinkFrame> frame;
    {
      const std::scoped_lock lock(mutex_);
      frame = latest_;
      encoded_ = status_.posted;
    }
    auto bytes = std::make_shared<std::vector<std::uint8_t>>();
    for (const LinkTransform& transform : frame->transforms) appendTransform(*bytes, transform, frame->time_ns);
    appendImage(*bytes, frame->image, frame->time_ns);
    return latestBytes_ = std::move(bytes);
  }

  void setLastError(std::string error) {
    const std::scoped_lock lock(mutex_);
    status_.lastError = std::move(error);
  }

  const Descriptor listening_;
  const int port_;
  const CommandHandler handler_;
  const std::shared_ptr<ReplyBox> box_ = std::make_shared<ReplyBox>();
  mutable std::mutex mutex_;  ///< guards latest_ and status_
  std::shared_ptr<const LinkFrame> latest_;
  LinkServerStatus status_;
  // The following members are used by the server's thread.
  std::vector<LinkPeer> peers_;
  std::uint64_t lastPeer_ = 0;
  Bytes latestBytes_;
  std::uint64_t encoded_ = 0;  ///< number of the frame in latestBytes_
  std::jthread thread_;
};

Result<std::unique_ptr<LinkServer>> LinkServer::start(const LinkServerOptions& options, CommandHandler handler) {
  auto listening = listenOn(options.port, options.anyAddress);
  if (!listening) return tl::unexpected(listening.error());
  return std::unique_ptr<LinkServer>(new LinkServer(std::make_unique<Impl>(std::move(*listening), std::move(handler))));
}

LinkServer::LinkServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LinkServer::~LinkServer() = default;

void LinkServer::post(std::shared_ptr<const LinkFrame> frame) {
  if (frame) impl_->post(std::move(frame));
}

int LinkServer::port() const {
  return impl_->port();
}

LinkServerStatus LinkServer::status() const {
  return impl_->status();
}

}  // namespace insonate
