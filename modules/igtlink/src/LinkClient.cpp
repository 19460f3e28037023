#include "LinkTime.h"
#include "SenderClock.h"
#include "Sockets.h"

#include <insonate/igtlink/LinkClient.h>

#include <poll.h>

#include <algorithm>
#include <array>
#include <deque>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace insonate {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kConnect_ns = 5 * kSecond_ns, kRetry_ns = kSecond_ns;
constexpr int kTick_ms = 100;
/// A sender that gives each message another name must not fill the memory.
constexpr std::size_t kMaxTools = 64;
constexpr int kResolution_ms = 5;

/// Arrivals of one tool's poses in the last second.
struct ToolHistory {
  std::string name;
  std::deque<std::int64_t> arrivals_ns;
  std::size_t most = 0;

  void forget(std::int64_t now_ns) {
    // The last arrival stays, for the time of silence.
    while (arrivals_ns.size() > 1 && now_ns - arrivals_ns.front() > kSecond_ns) arrivals_ns.pop_front();
  }
};

}  // namespace

class LinkClient::Impl {
 public:
  Impl(std::string host, int port, Listener listener)
      : host_(std::move(host)),
        port_(port),
        listener_(std::move(listener)),
        thread_([this](const std::stop_token& stop) { run(stop); }) {}
  ~Impl() {
    thread_.request_stop();
    wakeUp_.wake();
  }

  LinkClientStatus status() const {
    const std::int64_t now_ns = monotonicTime_ns();
    const std::scoped_lock lock(mutex_);
    LinkClientStatus status = status_;
    for (ToolHistory tool : tools_) {
      tool.forget(now_ns);
      const std::int64_t silent_ns = now_ns - tool.arrivals_ns.back();
      const double rate = silent_ns > kSecond_ns ? 0 : static_cast<double>(tool.arrivals_ns.size());
      const double quality = std::min(1.0, rate / static_cast<double>(tool.most));
      status.tools.push_back({tool.name, rate, quality, static_cast<double>(silent_ns) * 1e-6});
    }
    return status;
  }

 private:
  void run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      const std::string error = connectOnce(stop);
      {
        const std::scoped_lock lock(mutex_);
        status_.phase = LinkPhase::kConnecting;
        status_.error = error;
        tools_.clear();
      }
      const std::int64_t until_ns = monotonicTime_ns() + kRetry_ns;
      while (!stop.stop_requested() && monotonicTime_ns() < until_ns) {
        waitFor(nullptr, 0);
        listener_({}, error);
      }
    }
  }

  /// Connects and receives until the connection ends. Returns why.
  std::string connectOnce(const std::stop_token& stop) {
    auto connection = beginConnection(host_, port_, attempts_++);
    if (!connection) return connection.error().message;
    const std::int64_t until_ns = monotonicTime_ns() + kConnect_ns;
    while (!waitFor(&*connection, POLLOUT)) {
      if (stop.stop_requested()) return {};
      if (monotonicTime_ns() > until_ns) return host_ + " does not answer. Check its address and the network.";
      listener_({}, {});
    }
    if (std::string error = connectionError(*connection, host_, port_); !error.empty()) return error;
    std::vector<std::uint8_t> request;
    appendTrackingRequest(request, kResolution_ms);
    sendTo(*connection, request);
    LinkParser parser({"TRANSFORM", "TDATA", "QTDATA", "POSITION"});
    clock_ = {};
    {
      const std::scoped_lock lock(mutex_);
      status_ = {LinkPhase::kConnected, {}, status_.connections + 1, {}, {}};
    }
    while (!stop.stop_requested()) {
      if (!waitFor(&*connection, POLLIN))
        listener_({}, {});
      else if (std::string error = receive(*connection, parser); !error.empty())
        return error;
    }
    return {};
  }

  /// Waits for a tenth of a second, or until `connection` is ready, or until the client is destroyed.
  bool waitFor(const Descriptor* connection, short events) const {
    std::array<pollfd, 2> waiting{{{wakeUp_.get(), POLLIN, 0}, {connection ? connection->get() : -1, events, 0}}};
    poll(waiting.data(), waiting.size(), kTick_ms);
    return waiting[1].revents != 0;
  }

  std::string receive(const Descriptor& connection, LinkParser& parser) {
    std::array<std::uint8_t, 16 * 1024> buffer;
    const auto [size, closed] = receiveFrom(connection, buffer);
    if (closed) return "The connection to " + host_ + " was closed by the other program.";
    const auto ok = parser.feed({buffer.data(), size}, [&](LinkMessage&& message) { take(message); });
    const std::scoped_lock lock(mutex_);
    status_.counters = parser.counters();
    return ok ? std::string() : ok.error().message;
  }

  void take(const LinkMessage& message) {
    const std::int64_t arrived_ns = monotonicTime_ns();
    const std::int64_t time_ns = clock_.localTime_ns(message.time_ns, arrived_ns);
    std::vector<LinkToolPose> poses;
    for (LinkPose& pose : posesOf(message)) poses.push_back({std::move(pose.name), pose.trackerFromTool, time_ns});
    if (poses.empty()) return;
    {
      const std::scoped_lock lock(mutex_);
      for (const LinkToolPose& pose : poses) count(pose.name, arrived_ns);
    }
    listener_(poses, {});
  }

  void count(const std::string& name, std::int64_t arrived_ns) {
    auto tool = std::ranges::find(tools_, name, &ToolHistory::name);
    if (tool == tools_.end()) {
      if (tools_.size() == kMaxTools) return;
      tool = tools_.insert(tools_.end(), {name, {}, 0});
    }
    tool->arrivals_ns.push_back(arrived_ns);
    tool->forget(arrived_ns);
    tool->most = std::max(tool->most, tool->arrivals_ns.size());
  }

  const std::string host_;
  const int port_;
  const Listener listener_;
  const WakeUp wakeUp_;
  // The following members are used by the client's thread.
  SenderClock clock_;
  int attempts_ = 0;
  mutable std::mutex mutex_;  ///< guards status_ and tools_
  LinkClientStatus status_;
  std::vector<ToolHistory> tools_;
  std::jthread thread_;
};

LinkClient::LinkClient(std::string host, int port, Listener listener)
    : impl_(std::make_unique<Impl>(std::move(host), port, std::move(listener))) {}
LinkClient::~LinkClient() = default;

LinkClientStatus LinkClient::status() const {
  return impl_->status();
}

}  // namespace insonate
