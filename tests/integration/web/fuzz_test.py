"""Sends random requests to each address of insonate-server, in each role, with hostile values and broken HTTP.

fuzz_test.py SERVER ROUTES [SECONDS [SEED]]: SERVER is the program, ROUTES the source with its table of addresses. Each
minute begins with a new server and a made-up class. A crash, a finding of a sanitizer, a status of 500, a value that
comes back as HTML, or an address that was never reached is a failure.
"""

import html
import http.client
import pathlib
import random
import re
import socket
import subprocess
import sys
import tempfile
import time
import urllib.parse

ROUND_S = 60
MOST_VIDEOS = 10
PASSWORD = "made-up password"
ROLES = ("made-up-001", "made-up-teacher", "made-up-administrator")
MARK = "<fuzz>"
HOSTILE = [
    f"\"'>{MARK}", f"</textarea>{MARK}", f"javascript:{MARK}", "' OR 1=1 --", "'; DROP TABLE people; --", "../../../../etc/passwd",
    "..%2f..%2fetc%2fpasswd", "/etc/passwd", "%00", "\0", "\r\nSet-Cookie: a=b", "\u202e\u0007", "\ud83d\ude00" * 40, "ß" * 500,
    "9" * 400, "-1", "0", "1e309", "nan", "9223372036854775808", "2026-02-30T25:61", "99:99", "{}", "[" * 2000, "null", "on", "",
    "A" * 5000, "%", "%zz", "%ff%fe", "=&=&", ";;;,,,", "é\u0301" * 20,
]
HEADERS = ["Range", "Cookie", "Content-Type", "Accept", "Last-Event-ID", "If-None-Match", "X-Forwarded-For", "Origin", "Host",
           "Sec-Fetch-Site", "Authorization", "Content-Length", "Transfer-Encoding", "Expect", "Connection"]


def routes_in(source):
    found = re.findall(r'\{"(GET|POST)", "([^"]+)", Access::', pathlib.Path(source).read_text())
    if len(found) < 40:
        sys.exit(f"{source} has no table of addresses")
    return found


class Site:
    """One server with a made-up class, and what its pages say: ids, names of fields and their values."""

    def __init__(self, program):
        self.errors = tempfile.TemporaryFile("w+", errors="replace")
        # No identity provider listens at port 1: its addresses are answered, and nothing leaves this computer.
        self.secret = tempfile.NamedTemporaryFile("w")
        self.secret.write("secret\n")
        self.secret.flush()
        self.folder = tempfile.TemporaryDirectory()
        self.recordings, self.videos = (pathlib.Path(self.folder.name) / name for name in ("recordings", "videos"))
        self.process = subprocess.Popen([program, "--demo", "--listen", "127.0.0.1:0", "--recordings", self.recordings,
                                         "--videos", self.videos, "--openid-issuer", "http://127.0.0.1:1",
                                         "--openid-client", "c", "--openid-secret-file", self.secret.name, "--openid-name", "X"],
                                        stdout=subprocess.PIPE, stderr=self.errors, text=True)
        self.port = next(int(match.group(1)) for line in self.process.stdout
                         if (match := re.search(r"127\.0\.0\.1:(\d+)", line)))
        self.sessions, self.codes, self.attempts, self.ids, self.names, self.values, self.token = {}, {}, [], [], ["class"], [""], ""
        for role in ROLES:
            self.sign_in(role)
        self.learn("made-up-administrator")
        self.add_videos()

    def ask(self, method, path, body=None, headers=None, timeout=30):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        try:
            connection.request(method, path, body, headers or {})
            answer = connection.getresponse()
            is_stream = answer.getheader("Content-Type", "").startswith("text/event-stream")
            return answer.status, answer.headers, b"" if is_stream else answer.read()
        finally:
            connection.close()

    def sign_in(self, role):
        _, headers, _ = self.ask("POST", "/sign-in", urllib.parse.urlencode({"name": role, "password": PASSWORD, "next": "/"}),
                                 {"Content-Type": "application/x-www-form-urlencoded"})
        if match := re.search(r"insonate=(\w+)", headers.get("Set-Cookie", "")):
            self.sessions[role] = match.group(1)

    def learn(self, role):
        """Follows the links of a role, and notes what could be part of an address or of a form."""
        waiting, seen = ["/"], set()
        cookie = {"Cookie": f"insonate={self.sessions.get(role, '')}"}
        while waiting and len(seen) < 60:
            path = waiting.pop(0)
            kind = re.sub(r"[0-9a-f-]{36}", "*", path.split("?")[0])
            if kind in seen:
                continue
            seen.add(kind)
            status, headers, body = self.ask("GET", path, headers=cookie)
            if status == 303:
                waiting.insert(0, headers["Location"])
                continue
            text = html.unescape(body.decode(errors="replace"))
            waiting += [link for link in re.findall(r'href="(/[^"#]*)"', text) if "video.webm" not in link]
            self.attempts += re.findall(r"/attempts/([0-9a-f-]{36})", text)
            self.ids += re.findall(r"[0-9a-f]{8}-[0-9a-f-]{27}", path) + re.findall(r"/levels/([\w-]+)", path)
            self.ids += re.findall(r"/forms/([\w-]+)", path)
            self.names += re.findall(r' name="([^"]+)"', text) + re.findall(r"[?&](\w+)=", text)
            self.values += re.findall(r' value="([^"]{0,200})"', text)[:200]
        self.attempts = sorted(set(self.attempts))[:MOST_VIDEOS]
        self.ids += self.attempts
        self.ids, self.names, self.values = (sorted(set(one)) for one in (self.ids, self.names, self.values))

    def add_videos(self):
        """Gives the attempts recordings, and every second attempt a video: damaged files, which the server must endure."""
        self.recordings.mkdir(exist_ok=True)
        self.videos.mkdir(exist_ok=True)
        for number, attempt in enumerate(self.attempts):
            (self.recordings / f"{attempt}.attempt").write_bytes(b"no recording" * 100)
            if number % 2:
                (self.videos / f"{attempt}.webm").write_bytes(b"no video" * 1000)

    def code_of(self, role):
        """The code of the forms of a session, which a page of the session contains."""
        secret = self.sessions.get(role, "")
        if secret not in self.codes:
            _, _, body = self.ask("GET", "/password", headers={"Cookie": f"insonate={secret}"})
            found = re.search(rb'name="code" value="([^"]+)"', body)
            self.codes[secret] = found.group(1).decode() if found else ""
        return self.codes[secret]

    def end(self):
        """Ends the server; returns what is wrong with it."""
        code = self.process.poll()
        if code is None:
            self.process.terminate()
            code = self.process.wait(timeout=60)
        self.errors.seek(0)
        log = self.errors.read()
        found = re.search(r"(ERROR: \w+Sanitizer|runtime error:|terminate called|Assertion)[^\n]*", log)
        if found or code != 0:
            return [f"the server ended with status {code}: {found.group(0) if found else ''}\n{log[-3000:]}"]
        return []


class Fuzzer:
    def __init__(self, site, routes, seed):
        self.site, self.routes, self.random = site, routes, random.Random(seed)
        self.reached, self.statuses, self.troubles = set(), {}, []

    def value(self):
        some = self.random.random()
        if some < 0.4:
            return self.random.choice(HOSTILE)
        if some < 0.7 and self.site.ids:
            return self.random.choice(self.site.ids)
        text = self.random.choice(self.site.values)
        if some < 0.8 and text:
            place = self.random.randrange(len(text))
            return text[:place] + chr(self.random.choice([0, 10, 34, 38, 60, 127, 233, 0x202e])) + text[place + 1:]
        return text

    def path(self, route):
        def part(_):
            if self.site.ids and self.random.random() < 0.75:
                return self.random.choice(self.site.ids)
            return urllib.parse.quote(self.value(), safe="", errors="replace")
        return re.sub(r"\*", part, route)

    def fields(self, role):
        names = self.random.sample(self.site.names, min(len(self.site.names), self.random.randrange(1, 12)))
        form = {name: self.value() for name in names}
        if self.random.random() < 0.9:
            form["code"] = self.site.code_of(role)
        return form

    def multipart(self, role):
        edge = self.random.choice(["edge", "-" * 60, "a b"])
        parts = "".join(f'--{edge}\r\nContent-Disposition: form-data; name="{name}"'
                        + self.random.choice(["", '; filename="a.csv"', "; filename=\"../x\""]) + f"\r\n\r\n{value}\r\n"
                        for name, value in self.fields(role).items())
        body = (parts + f"--{edge}--\r\n").encode(errors="replace")
        return body[:self.random.randrange(len(body) + 1)] if self.random.random() < 0.2 else body, f"multipart/form-data; boundary={edge}"

    def json(self):
        return self.random.choice(['{"protocol": 1, "people": [%s]}', '{"attempts": [{"id": "%s"}]}', '{"%s": 1}', "[%s", "%s", "{}"]) \
            .replace("%s", self.value().replace('"', "'"))

    def request(self):
        method, route = self.random.choice(self.routes)
        role = self.random.choice((*ROLES, "guest"))
        path, headers, body = self.path(route), {}, None
        if role in self.site.sessions:
            headers["Cookie"] = f"insonate={self.site.sessions[role]}"
        if self.random.random() < 0.4:
            path += "?" + urllib.parse.urlencode({self.random.choice(self.site.names): self.value() for _ in range(3)}, errors="replace")
        if method == "POST" and route.startswith("/api/"):
            body, headers["Authorization"] = self.json().encode(errors="replace"), f"Bearer {self.site.token or self.value()[:50]}"
        elif method == "POST":
            headers["Sec-Fetch-Site"] = "same-origin"
            if self.random.random() < 0.2:
                body, headers["Content-Type"] = self.multipart(role)
            else:
                body = urllib.parse.urlencode(self.fields(role), errors="replace").encode()
                headers["Content-Type"] = "application/x-www-form-urlencoded"
        if self.random.random() < 0.1:
            headers[self.random.choice(HEADERS)] = re.sub(r"[^\x20-\x7e]", "?", self.value())
        if self.random.random() < 0.03:
            method = self.random.choice(["PUT", "DELETE", "HEAD", "OPTIONS", "TRACE", "POST", "GET"])
        try:
            status, answer, content = self.site.ask(method, path, body, headers)
        except (http.client.HTTPException, OSError, ValueError):
            return  # a refused header or a closed connection; a server that has ended is found at the end of the round
        self.statuses[status] = self.statuses.get(status, 0) + 1
        if status not in (404, 405):
            self.reached.add((method, route))
        self.check(f"{method} {path[:300]} as {role}", status, answer, content)
        if route == "/workstations" and (found := re.search(rb'class="token">([^<]+)<', content)):
            self.site.token = found.group(1).decode()
        if role in ROLES and status == 303 and answer.get("Location", "").startswith("/sign-in"):
            self.site.sign_in(role)

    def check(self, what, status, answer, content):
        if status == 500 or status > 503:
            self.troubles.append(f"{what}: status {status}")
        if "text/html" in answer.get("Content-Type", "") and MARK.encode() in content:
            self.troubles.append(f"{what}: a value comes back as HTML")
        if answer.get("Location", "/").startswith(("//", "/\\", "http")):
            self.troubles.append(f"{what}: leads to {answer['Location']}")
        if "a=b" in answer.get("Set-Cookie", ""):
            self.troubles.append(f"{what}: a value became a header")

    def broken(self):
        """Bytes that are nearly a request; the connection may end at any time."""
        method, route = self.random.choice(self.routes)
        lines = [f"{method} {self.path(route)} HTTP/1.1", "Host: localhost", "Content-Length: 10",
                 self.random.choice(HEADERS) + ": " + self.value().replace("\n", " ")]
        data = bytearray(("\r\n".join(lines) + "\r\n\r\n0123456789").encode(errors="replace"))
        for _ in range(self.random.randrange(4)):
            data[self.random.randrange(len(data))] = self.random.randrange(256)
        with socket.create_connection(("127.0.0.1", self.site.port), timeout=5) as connection:
            try:
                connection.sendall(data[:self.random.randrange(len(data) + 1)] if self.random.random() < 0.3 else data)
                if self.random.random() < 0.5:
                    connection.shutdown(socket.SHUT_WR)
                    connection.settimeout(0.2)
                    connection.recv(4096)
            except OSError:
                pass  # refused, as it should be

    def run(self, until):
        count = 0
        while time.monotonic() < until and self.site.process.poll() is None and len(self.troubles) < 20:
            try:
                self.broken() if self.random.random() < 0.1 else self.request()
            except OSError:
                pass
            count += 1
        return count


def main():
    program, routes = sys.argv[1], routes_in(sys.argv[2])
    seconds = float(sys.argv[3]) if len(sys.argv) > 3 else 20
    seed = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    end, count, reached, statuses, troubles = time.monotonic() + seconds, 0, set(), {}, []
    while time.monotonic() < end and not troubles:
        site = Site(program)
        fuzzer = Fuzzer(site, routes, seed)
        count += fuzzer.run(min(end, time.monotonic() + ROUND_S))
        troubles += fuzzer.troubles + site.end()
        reached |= fuzzer.reached
        for status, times in fuzzer.statuses.items():
            statuses[status] = statuses.get(status, 0) + times
        print(f"seed {seed}: {count} requests so far", flush=True)
        seed += 1
    missed = [] if seconds < ROUND_S else [f"{method} {route} was never reached" for method, route in routes if (method, route) not in reached]
    print(f"{count} requests, answers by status: {dict(sorted(statuses.items()))}")
    print("\n".join((troubles + missed)[:50]) if troubles or missed else "No finding.")
    return 1 if troubles or missed else 0


sys.exit(main())
