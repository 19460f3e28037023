#include "http/HttpServer.h"

#include "http/Certificate.h"
#include "http/ClientAddress.h"
#include "http/ConnectionDeadlines.h"
#include "http/EventStream.h"
#include "http/SocketAddress.h"
#include "openid/OpenIdPages.h"
#include "site/SiteApi.h"

#include <fcntl.h>
#include <microhttpd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace insonate::web {
namespace {

/// The hash of a password takes 0.1 s, a class list has hundreds, and the data of a person may have gigabytes: these
/// requests have workers of their own. A slow identity provider must stop no page: these requests do, too.
constexpr int kWorkers = 4, kPasswordWorkers = 2, kAccountWorkers = 1, kProviderWorkers = 2, kDataWorkers = 1;
constexpr std::size_t kHeaderMemory_bytes = 32 << 10;
/// Bodies of all connections together; those of workstations and class lists leave room for forms.
constexpr std::size_t kMostBodies_bytes = std::size_t{256} << 20,
                      kMostBodiesOfWorkstations_bytes = std::size_t{192} << 20;
/// Requests that wait for a worker; further ones are told to come back, since a queue without limit only grows.
constexpr std::size_t kMostWaiting = 500;
/// Each of these requests may take 30 s.
constexpr std::size_t kMostWaitingForProvider = 40;

/// Progress of a request. Its connection is suspended while a worker checks the sender or makes the answer.
enum class Stage {
  Receiving,  ///< headers or body arrive
  Admission,  ///< a worker checks the sender before a large body is received
  Answer      ///< the request is complete, and a worker makes or has made the answer
};

/// A request that is being received or answered. Owned by its connection.
struct Exchange {
  MHD_Connection* connection = nullptr;
  int socket = -1;
  Request request{};
  std::size_t largest_bytes = 0;  ///< limit of the body
  bool isCut = false;             ///< a part of the body was not kept, since it or all bodies together are too large
  Stage stage = Stage::Receiving;
  std::optional<Response> refusal{};  ///< if set, the sender is unknown, and the body is not kept
  Response response{};
};

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

std::string addressOf(MHD_Connection* connection) {
  const auto* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CLIENT_ADDRESS);
  return info && info->client_addr ? textOf(*info->client_addr) : "";
}

/// Keeps addresses as they were sent: requestOf() decodes them, exactly once.
std::size_t keepEncoded(void* /*self*/, MHD_Connection* /*connection*/, char* text) {
  return std::strlen(text);
}

/// Counts headers by which a body's length could be read in two ways, so that a proxy in front reads another request.
MHD_Result countLengths(void* count, MHD_ValueKind /*kind*/, const char* key, const char* /*value*/) {
  const std::string name = lowerCase(key);
  if (name == "content-length" || name == "transfer-encoding") ++*static_cast<int*>(count);
  return MHD_YES;
}

MHD_Result addField(void* fields, MHD_ValueKind /*kind*/, const char* key, const char* value) {
  static_cast<Fields*>(fields)->emplace(key, value ? value : "");
  return MHD_YES;
}

/// A header that occurs again is ignored, but for the one to which each proxy on the way adds a line.
MHD_Result addHeader(void* headers, MHD_ValueKind /*kind*/, const char* key, const char* value) {
  auto& fields = *static_cast<Fields*>(headers);
  const auto [place, isNew] = fields.emplace(lowerCase(key), value ? value : "");
  if (!isNew && place->first == "x-forwarded-for") place->second += std::string(", ") + (value ? value : "");
  return MHD_YES;
}

int socketOf(MHD_Connection* connection) {
  const auto* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
  return info ? info->connect_fd : -1;
}

Request requestOf(MHD_Connection* connection, const char* url, const char* method) {
  Request request;
  request.method = std::strcmp(method, "HEAD") == 0 ? "GET" : method;
  request.path = decoded(url, false);
  Fields query;
  MHD_get_connection_values(connection, MHD_GET_ARGUMENT_KIND, &addField, &query);
  for (const auto& [key, value] : query) request.query.emplace(decoded(key, false), decoded(value, false));
  MHD_get_connection_values(connection, MHD_HEADER_KIND, &addHeader, &request.headers);
  request.cookies = fieldsOfCookies(valueOf(request.headers, "cookie"));
  request.client = addressOf(connection);
  return request;
}

/// A stream as the library reads it; owned by the library's response.
struct StreamReader {
  std::shared_ptr<EventStream> stream;
  MHD_Connection* connection;
};

MHD_Response* streamResponse(MHD_Connection* connection, const std::shared_ptr<EventStream>& stream) {
  constexpr std::size_t kBlock_bytes = 1024;
  const auto read = [](void* self, std::uint64_t /*position*/, char* to, std::size_t max_bytes) -> ssize_t {
    const auto& reader = *static_cast<StreamReader*>(self);
    return reader.stream->read(reader.connection, to, max_bytes, MHD_CONTENT_READER_END_OF_STREAM);
  };
  const auto release = [](void* self) {
    static_cast<StreamReader*>(self)->stream->detach();
    delete static_cast<StreamReader*>(self);
  };
  auto reader = std::make_unique<StreamReader>(StreamReader{stream, connection});
  MHD_Response* response =
      MHD_create_response_from_callback(MHD_SIZE_UNKNOWN, kBlock_bytes, read, reader.get(), release);
  if (response) (void)reader.release();
  return response;
}

/// The library closes the file.
MHD_Response* responseOf(const Response& answer) {
  if (answer.file.empty())
    return MHD_create_response_from_buffer(answer.body.size(), const_cast<char*>(answer.body.data()),
                                           MHD_RESPMEM_MUST_COPY);
  const int file = ::open(answer.file.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return nullptr;
  MHD_Response* response = MHD_create_response_from_fd_at_offset64(answer.fileSize, file, answer.fileBegin);
  if (!response) ::close(file);
  return response;
}

MHD_Result send(MHD_Connection* connection, const Response& answer) {
  MHD_Response* response = answer.events ? streamResponse(connection, answer.events) : responseOf(answer);
  if (!response) return MHD_NO;
  MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, answer.type.c_str());
  for (const auto& [name, value] : answer.headers) MHD_add_response_header(response, name.c_str(), value.c_str());
  const MHD_Result queued = MHD_queue_response(connection, static_cast<unsigned>(answer.status), response);
  MHD_destroy_response(response);
  return queued;
}

Response plain(int status, std::string sentence) {
  return {.status = status, .type = "text/plain; charset=utf-8", .body = std::move(sentence) + "\n"};
}

/// Attempts and parts of recordings are larger than forms.
bool isOfWorkstation(const Request& request) {
  return request.path.starts_with(kSiteApi) && !valueOf(request.headers, "authorization").empty();
}

/// A list of people and a curriculum are larger than other forms.
bool isList(const Request& request) {
  const bool isOfClass = request.path.starts_with("/classes/") &&
                         (request.path.ends_with("/import") || request.path.ends_with("/import/confirm"));
  return (isOfClass || request.path == "/curricula") && !request.cookies.empty();
}

std::size_t largestBodyOf(const Request& request) {
  if (isOfWorkstation(request)) return HttpServer::kLargestBodyOfWorkstation_bytes;
  return isList(request) ? HttpServer::kLargestBodyOfList_bytes : HttpServer::kLargestBody_bytes;
}

/// Tells whether a body may exceed the limit of unknown senders. A body without a stated length may.
bool isLargerThanForms(MHD_Connection* connection, std::size_t announced_bytes) {
  return announced_bytes > HttpServer::kLargestBody_bytes ||
         MHD_lookup_connection_value(connection, MHD_HEADER_KIND, MHD_HTTP_HEADER_TRANSFER_ENCODING);
}

/// Takes the parts of a multipart form, of which each arrives in pieces.
struct PartTaker {
  Request* request = nullptr;
  std::string* value = nullptr;  ///< of the part that arrives; null: another part had the same name before
};

MHD_Result takePart(void* state, MHD_ValueKind /*kind*/, const char* key, const char* fileName, const char* /*type*/,
                    const char* /*encoding*/, const char* data, std::uint64_t offset, std::size_t size) {
  auto& taker = *static_cast<PartTaker*>(state);
  if (offset == 0) {
    Fields& fields = fileName ? taker.request->files : taker.request->form;
    const auto [place, isNew] = fields.emplace(key ? key : "", "");
    taker.value = isNew ? &place->second : nullptr;
  }
  if (taker.value) taker.value->append(data, size);
  return MHD_YES;
}

/// Reads the form in a request's body; false: the body is no form.
bool readForm(MHD_Connection* connection, Request& request) {
  if (!lowerCase(valueOf(request.headers, "content-type")).starts_with("multipart/")) {
    request.form = fieldsOfForm(request.body);
    return true;
  }
  constexpr std::size_t kBuffer_bytes = 4096;
  PartTaker taker{.request = &request};
  MHD_PostProcessor* reader = MHD_create_post_processor(connection, kBuffer_bytes, &takePart, &taker);
  if (!reader) return false;
  const MHD_Result read = MHD_post_process(reader, request.body.data(), request.body.size());
  const bool isWhole = MHD_destroy_post_processor(reader) == MHD_YES && read == MHD_YES;
  for (auto& [name, value] : request.form) value = plainText(value);
  return isWhole;
}

bool checksPassword(const Request& request) {
  return request.method == "POST" && (request.path == "/sign-in" || request.path == "/password" ||
                                      request.path == "/api/site/sign-in" || request.path == "/api/site/password");
}

/// Tells whether a request sets the passwords of others: adding people, importing a list, or a new password.
bool setsPasswords(const Request& request) {
  const std::string_view path = request.path;
  return request.method == "POST" &&
         (path == "/people" || (path.starts_with("/people/") && path.ends_with("/password")) ||
          path.ends_with("/members/new") || path.ends_with("/import/confirm"));
}

bool asksProvider(const Request& request) {
  return request.path == kOpenIdSignIn || request.path == kOpenIdReturn;
}

/// Tells whether a request downloads all data of a person.
bool downloadsData(const Request& request) {
  const std::string_view path = request.path;
  return request.method == "POST" && (path == "/me/data" || (path.starts_with("/people/") && path.ends_with("/data")));
}

}  // namespace

struct HttpServer::Impl {
  Answer answer;
  Refused refused;
  Admit admit;
  HttpLimits limits;
  Certificate certificate;
  ConnectionDeadlines deadlines;
  MHD_Daemon* daemon = nullptr;
  std::mutex mutex;
  std::condition_variable wake;
  std::deque<Exchange*> waiting, waitingForPassword, waitingForAccounts, waitingForProvider, waitingForData;
  bool stopping = false;
  // Used by the thread that receives.
  std::size_t bodies_bytes = 0;
  std::map<std::string, unsigned> connectionsOf{};  ///< number of connections by network; the library counts whole
                                                    ///< addresses, of which an IPv6 client has many
  unsigned mostConnectionsOfNetwork = 0;
  std::vector<std::thread> workers;

  void work(std::deque<Exchange*>& queue);
  std::deque<Exchange*>& queueFor(const Request& request);
  bool submit(Exchange* exchange, Stage stage);
  MHD_Result refuseBusy(MHD_Connection* connection) const;
  MHD_Result refuse(MHD_Connection* connection, const Response& response) const;
  MHD_Result begin(MHD_Connection* connection, const char* url, const char* method, void** state);
  MHD_Result take(Exchange& exchange, const char* data, std::size_t* size);

  static MHD_Result mayConnect(void* self, const sockaddr* address, socklen_t size);
  static MHD_Result onRequest(void* self, MHD_Connection* connection, const char* url, const char* method,
                              const char* version, const char* data, std::size_t* size, void** state);
  static void onConnection(void* self, MHD_Connection* connection, void** state, MHD_ConnectionNotificationCode code);
  static void onEnd(void* self, MHD_Connection* connection, void** state, MHD_RequestTerminationCode code);
};

void HttpServer::Impl::work(std::deque<Exchange*>& queue) {
  for (;;) {
    Exchange* exchange = nullptr;
    bool isLate = false;
    {
      std::unique_lock lock(mutex);
      wake.wait(lock, [&] { return stopping || !queue.empty(); });
      if (queue.empty()) return;
      exchange = queue.front();
      queue.pop_front();
      isLate = stopping;
    }
    const Response ending = plain(503, "The server is shutting down. Try again in a minute.");
    if (exchange->stage == Stage::Admission)
      exchange->refusal = isLate ? ending : admit(exchange->request);
    else
      exchange->response = isLate ? ending : answer(exchange->request);
    MHD_resume_connection(exchange->connection);
  }
}

std::deque<Exchange*>& HttpServer::Impl::queueFor(const Request& request) {
  if (asksProvider(request)) return waitingForProvider;
  if (setsPasswords(request)) return waitingForAccounts;
  if (downloadsData(request)) return waitingForData;
  return checksPassword(request) ? waitingForPassword : waiting;
}

/// Hands a request to a worker, which resumes the connection.
bool HttpServer::Impl::submit(Exchange* exchange, Stage stage) {
  const std::lock_guard lock(mutex);
  std::deque<Exchange*>& queue = queueFor(exchange->request);
  if (stopping || queue.size() >= (&queue == &waitingForProvider ? kMostWaitingForProvider : kMostWaiting))
    return false;
  exchange->stage = stage;
  deadlines.set(exchange->socket, std::nullopt);
  // Before a worker can see the exchange, since it may resume the connection at once.
  MHD_suspend_connection(exchange->connection);
  queue.push_back(exchange);
  wake.notify_all();
  return true;
}

MHD_Result HttpServer::Impl::refuse(MHD_Connection* connection, const Response& response) const {
  if (refused) refused(response.status);
  return send(connection, response);
}

MHD_Result HttpServer::Impl::refuseBusy(MHD_Connection* connection) const {
  Response busy = plain(503, "The server is busy. Try again in a few seconds.");
  busy.headers.emplace_back("Retry-After", "5");
  return refuse(connection, busy);
}

MHD_Result HttpServer::Impl::begin(MHD_Connection* connection, const char* url, const char* method, void** state) {
  const char* length = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, MHD_HTTP_HEADER_CONTENT_LENGTH);
  std::size_t announced_bytes = 0;
  if (length) std::from_chars(length, length + std::strlen(length), announced_bytes);
  int lengths = 0;
  MHD_get_connection_values(connection, MHD_HEADER_KIND, &countLengths, &lengths);
  if (lengths > 1) return refuse(connection, plain(400, "The length of the request is stated twice."));
  Request request = requestOf(connection, url, method);
  const std::size_t largest_bytes = largestBodyOf(request);
  const bool needsAdmission = largest_bytes > kLargestBody_bytes && isLargerThanForms(connection, announced_bytes);
  if (announced_bytes > largest_bytes || (needsAdmission && !admit))
    return refuse(connection, plain(413, "The request is too large."));
  auto* exchange = new Exchange{.connection = connection,
                                .socket = socketOf(connection),
                                .request = std::move(request),
                                .largest_bytes = largest_bytes};
  *state = exchange;
  return !needsAdmission || submit(exchange, Stage::Admission) ? MHD_YES : refuseBusy(connection);
}

/// Takes a part of the body; after the last part, hands the request to a worker.
MHD_Result HttpServer::Impl::take(Exchange& exchange, const char* data, std::size_t* size) {
  if (exchange.stage == Stage::Admission) {  // the library repeats its first call, without a body
    exchange.stage = Stage::Receiving;
    deadlines.set(exchange.socket, limits.request);
    return MHD_YES;
  }
  if (exchange.refusal) {
    if (*size == 0) return send(exchange.connection, *exchange.refusal);
    *size = 0;
    return MHD_YES;
  }
  if (*size > 0) {
    std::string& body = exchange.request.body;
    const bool isLarge = exchange.largest_bytes > kLargestBody_bytes;
    const std::size_t max_bytes = isLarge ? kMostBodiesOfWorkstations_bytes : kMostBodies_bytes;
    if (body.size() <= exchange.largest_bytes && bodies_bytes + *size <= max_bytes) {
      body.append(data, *size);
      bodies_bytes += *size;
    } else {
      exchange.isCut = true;
    }
    *size = 0;
    return MHD_YES;
  }
  if (exchange.stage == Stage::Answer) {
    constexpr std::uint64_t kSlowest_bytesPerMs = 64;
    const auto longest = limits.answer + std::chrono::milliseconds(exchange.response.fileSize / kSlowest_bytesPerMs);
    deadlines.set(exchange.socket, exchange.response.events ? std::nullopt : std::optional(longest));
    return send(exchange.connection, exchange.response);
  }
  if (exchange.isCut && exchange.request.body.size() <= exchange.largest_bytes)
    return refuse(exchange.connection, plain(503, "The server is busy. Try again in a few seconds."));
  if (exchange.isCut || exchange.request.body.size() > exchange.largest_bytes)
    return refuse(exchange.connection, plain(413, "The request is too large."));
  if (!isOfWorkstation(exchange.request) && !readForm(exchange.connection, exchange.request))
    return refuse(exchange.connection, plain(400, "The form cannot be read. Go back and send it again."));
  return submit(&exchange, Stage::Answer) ? MHD_YES : refuseBusy(exchange.connection);
}

MHD_Result HttpServer::Impl::onRequest(void* self, MHD_Connection* connection, const char* url, const char* method,
                                       const char* /*version*/, const char* data, std::size_t* size, void** state) {
  auto& server = *static_cast<Impl*>(self);
  if (!*state) return server.begin(connection, url, method, state);
  return server.take(*static_cast<Exchange*>(*state), data, size);
}

MHD_Result HttpServer::Impl::mayConnect(void* self, const sockaddr* address, socklen_t /*size*/) {
  const auto& server = *static_cast<Impl*>(self);
  const auto found = server.connectionsOf.find(networkOf(textOf(*address)));
  return found == server.connectionsOf.end() || found->second < server.mostConnectionsOfNetwork ? MHD_YES : MHD_NO;
}

/// The library calls this for the end of a connection before it closes the socket.
void HttpServer::Impl::onConnection(void* self, MHD_Connection* connection, void** /*state*/,
                                    MHD_ConnectionNotificationCode code) {
  auto& server = *static_cast<Impl*>(self);
  const std::string network = networkOf(addressOf(connection));
  if (code == MHD_CONNECTION_NOTIFY_STARTED) {
    ++server.connectionsOf[network];
    server.deadlines.add(socketOf(connection), server.limits.request);
  } else {
    if (--server.connectionsOf[network] == 0) server.connectionsOf.erase(network);
    server.deadlines.remove(socketOf(connection));
  }
}

/// The connection may be used for another request, which has its own time.
void HttpServer::Impl::onEnd(void* self, MHD_Connection* connection, void** state,
                             MHD_RequestTerminationCode /*code*/) {
  auto& server = *static_cast<Impl*>(self);
  server.deadlines.set(socketOf(connection), server.limits.request);
  if (const auto* exchange = static_cast<Exchange*>(*state)) server.bodies_bytes -= exchange->request.body.size();
  delete static_cast<Exchange*>(*state);
  *state = nullptr;
}

HttpServer::HttpServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<HttpServer>> HttpServer::start(const WebOptions& options, Answer answer,
                                                      const HttpLimits& limits, Refused refused, Admit admit) {
  auto impl = std::make_unique<Impl>();
  impl->answer = std::move(answer);
  impl->limits = limits;
  impl->refused = std::move(refused);
  impl->admit = std::move(admit);
  const auto address = resolvedAddress(options.address);
  if (!address) return tl::unexpected(address.error());
  const sockaddr_storage socket = socketAddress(*address, options.port);
  unsigned flags = MHD_USE_EPOLL | MHD_USE_INTERNAL_POLLING_THREAD | MHD_ALLOW_SUSPEND_RESUME;
  // "::" stands for all addresses, also those of IPv4.
  if (socket.ss_family == AF_INET6) flags |= *address == "::" ? MHD_USE_DUAL_STACK : MHD_USE_IPv6;
  std::vector<MHD_OptionItem> more;
  if (!options.certificate.empty()) {
    using namespace std::chrono;
    const std::int64_t now_s = duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
    auto certificate = readCertificate(options.certificate, options.key, now_s);
    if (!certificate) return tl::unexpected(certificate.error());
    impl->certificate = std::move(*certificate);
    flags |= MHD_USE_TLS;
    more.push_back({MHD_OPTION_HTTPS_MEM_CERT, 0, impl->certificate.chain.data()});
    more.push_back({MHD_OPTION_HTTPS_MEM_KEY, 0, impl->certificate.key.data()});
    static char priorities[] = "NORMAL:-VERS-ALL:+VERS-TLS1.3:+VERS-TLS1.2";
    more.push_back({MHD_OPTION_HTTPS_PRIORITIES, 0, priorities});
  }
  more.push_back({MHD_OPTION_END, 0, nullptr});
  const bool isBehindProxy = options.behindProxy || !options.proxies.empty();
  impl->mostConnectionsOfNetwork = isBehindProxy ? limits.connections : limits.connectionsOfOneAddress;
  impl->daemon = MHD_start_daemon(
      flags, 0, &Impl::mayConnect, impl.get(), &Impl::onRequest, impl.get(), MHD_OPTION_SOCK_ADDR, &socket,
      MHD_OPTION_NOTIFY_COMPLETED, &Impl::onEnd, impl.get(), MHD_OPTION_NOTIFY_CONNECTION, &Impl::onConnection,
      impl.get(), MHD_OPTION_CONNECTION_TIMEOUT, limits.idle_s, MHD_OPTION_CONNECTION_LIMIT, limits.connections,
      MHD_OPTION_CONNECTION_MEMORY_LIMIT, kHeaderMemory_bytes, MHD_OPTION_STRICT_FOR_CLIENT, 1,
      MHD_OPTION_UNESCAPE_CALLBACK, &keepEncoded, nullptr, MHD_OPTION_ARRAY, more.data(), MHD_OPTION_END);
  if (!impl->daemon)
    return fail("The server cannot listen at " + withPort(*address, options.port) +
                ". Another program may use this port, or the address is not one of this computer; choose another one "
                "with --listen.");
  const auto start = [server = impl.get()](int count, std::deque<Exchange*>& queue) {
    for (int i = 0; i < count; ++i) server->workers.emplace_back([server, &queue] { server->work(queue); });
  };
  start(kWorkers, impl->waiting);
  start(kPasswordWorkers, impl->waitingForPassword);
  start(kAccountWorkers, impl->waitingForAccounts);
  start(kProviderWorkers, impl->waitingForProvider);
  start(kDataWorkers, impl->waitingForData);
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(impl)));
}

HttpServer::~HttpServer() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->stopping = true;
  }
  impl_->wake.notify_all();
  // Workers answer what waits, so that no suspended connection is left, which the library does not allow.
  for (std::thread& worker : impl_->workers) worker.join();
  MHD_stop_daemon(impl_->daemon);
}

int HttpServer::port() const {
  const auto* info = MHD_get_daemon_info(impl_->daemon, MHD_DAEMON_INFO_BIND_PORT);
  return info ? info->port : 0;
}

}  // namespace insonate::web
