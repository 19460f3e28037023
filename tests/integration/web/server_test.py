"""Runs insonate-server as a hospital does: with a certificate, a configuration file, and faults in both.

server_test.py SERVER BUILD: SERVER is the program, BUILD the folder to install it from. Exit status 77: the program openssl is not here.
"""

import http.client
import json
import pathlib
import re
import shutil
import ssl
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

SERVER, BUILD = sys.argv.pop(1), sys.argv.pop(1)
PASSWORD = "made-up password"


def openssl(*arguments):
    subprocess.run(["openssl", *map(str, arguments)], check=True, capture_output=True)


def make_certificate(folder, name):
    """Makes a key and a certificate for localhost that signs itself; returns both files."""
    key, chain = folder / f"{name}.key", folder / f"{name}.pem"
    openssl("req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-keyout", key, "-out", chain,
            "-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1", "-days", "2")
    return chain, key


def make_expired_certificate(folder):
    """Only `openssl ca` makes a certificate of the past."""
    key, request, chain, settings = (folder / name for name in ("expired.key", "expired.csr", "expired.pem", "ca.conf"))
    openssl("req", "-new", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-keyout", key, "-out", request,
            "-subj", "/CN=localhost")
    (folder / "index.txt").touch()
    settings.write_text("[ca]\ndefault_ca = own\n[own]\nrand_serial = yes\ndefault_md = sha256\npolicy = any\n"
                        f"database = {folder}/index.txt\nnew_certs_dir = {folder}\n[any]\ncommonName = supplied\n")
    openssl("ca", "-batch", "-selfsign", "-config", settings, "-keyfile", key, "-in", request, "-out", chain, "-notext",
            "-startdate", "20200101000000Z", "-enddate", "20200201000000Z")
    return chain, key


class Server:
    """A running server; its log is in `log` after the end."""

    def __init__(self, *arguments):
        self.log = []
        self.errors = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen([SERVER, *map(str, arguments)], stdout=subprocess.PIPE, stderr=self.errors, text=True)
        for line in self.process.stdout:
            if match := re.search(r"(https?)://127\.0\.0\.1:(\d+)/", line):
                self.scheme, self.port = match.group(1), int(match.group(2))
                return
        raise RuntimeError(self.end())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    def end(self):
        self.process.terminate()
        status = self.process.wait(timeout=30)
        self.errors.seek(0)
        text = self.errors.read()
        self.errors.close()
        self.process.stdout.close()
        self.log = [json.loads(line) for line in text.splitlines() if line.startswith("{")]
        return f"status {status}: {text}"

    def ask(self, method, path, form=None, context=None, **headers):
        if self.scheme == "https":
            connection = http.client.HTTPSConnection("localhost", self.port, context=context, timeout=30)
        else:
            connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        body = urllib.parse.urlencode(form) if form else None
        if form:
            headers["Content-Type"] = "application/x-www-form-urlencoded"
        connection.request(method, path, body, {name.replace("_", "-"): value for name, value in headers.items()})
        answer = connection.getresponse()
        answer.text = answer.read().decode()
        connection.close()
        return answer


def refusal(*arguments):
    """What a server says that does not start."""
    done = subprocess.run([SERVER, *map(str, arguments)], capture_output=True, text=True, timeout=60)
    return done.returncode, done.stderr.strip(), done.stdout


class InAFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="insonate-server-"))
        self.addCleanup(shutil.rmtree, self.folder)


class Https(InAFolder):
    def test_pages_are_served_with_a_certificate(self):
        chain, key = make_certificate(self.folder, "own")
        with Server("--demo", "--listen", "127.0.0.1:0", "--certificate", chain, "--key", key) as server:
            self.assertEqual(server.scheme, "https")
            trusting = ssl.create_default_context(cafile=chain)
            self.assertEqual(server.ask("GET", "/sign-in", context=trusting).status, 200)
            signed_in = server.ask("POST", "/sign-in", {"name": "made-up-001", "password": PASSWORD, "next": "/me?level=x"},
                                   trusting)
            self.assertEqual((signed_in.status, signed_in.headers["Location"]), (303, "/me?level=x"))
            cookie = signed_in.headers["Set-Cookie"]
            self.assertTrue(cookie.startswith("__Host-insonate=") and "Secure" in cookie, cookie)
            own = server.ask("GET", "/me", context=trusting, Cookie=cookie.split(";")[0])
            self.assertEqual(own.status, 200)
            self.assertIn("max-age", own.headers["Strict-Transport-Security"])
            with self.assertRaises(ssl.SSLError):
                server.ask("GET", "/sign-in", context=ssl.create_default_context())
            old = ssl.create_default_context(cafile=chain)
            old.minimum_version, old.maximum_version = ssl.TLSVersion.TLSv1, ssl.TLSVersion.TLSv1_1
            with self.assertRaises((ssl.SSLError, ConnectionError)):
                server.ask("GET", "/sign-in", context=old)
            plain = http.client.HTTPConnection("127.0.0.1", server.port, timeout=30)
            with self.assertRaises((http.client.HTTPException, ConnectionError)):
                plain.request("GET", "/sign-in")
                plain.getresponse()

    def test_each_fault_of_a_certificate_has_a_sentence(self):
        chain, key = make_certificate(self.folder, "own")
        _, other_key = make_certificate(self.folder, "other")
        expired, expired_key = make_expired_certificate(self.folder)
        text, locked = self.folder / "text.pem", self.folder / "locked.key"
        text.write_text("not a certificate\n")
        openssl("pkey", "-in", key, "-out", locked, "-aes256", "-passout", "pass:secret")
        # A database that does not exist: options are checked first.
        for files, said in {(self.folder / "none.pem", key): "none.pem cannot be read",
                            (chain, self.folder): "is a folder",
                            (text, key): "text.pem contains no certificate in PEM",
                            (chain, text): "text.pem contains no private key in PEM",
                            (chain, locked): "has a passphrase",
                            (chain, other_key): "other.key does not belong to the certificate",
                            (expired, expired_key): "expired on 1 Feb 2020"}.items():
            status, error, output = refusal(self.folder / "none.db", "--certificate", files[0], "--key", files[1])
            self.assertEqual((status, output), (1, ""), files)
            self.assertIn(said, error)
            self.assertEqual(len(error.splitlines()), 1, error)
        self.assertIn("belong together", refusal("--demo", "--certificate", chain)[1])
        self.assertIn("not an IP address", refusal("--demo", "--proxy", "proxy.example")[1])


class Operation(InAFolder):
    def configuration(self, **keys):
        """A configuration file of these keys, as TOML."""
        file = self.folder / "server.conf"
        file.write_text("# comment\n" + "".join(f"{key.replace('_', '-')} = {json.dumps(value)}\n" for key, value in keys.items()))
        return file

    def test_the_configuration_file_says_what_the_command_line_says(self):
        token = self.folder / "token"
        token.write_text("0123456789abcdef\n")
        file = self.configuration(demo=True, listen="127.0.0.1:0", behind_proxy=True, proxy=["127.0.0.1"],
                                  monitoring_token_file=str(token))
        with Server("--config", file) as server:
            signed_in = server.ask("POST", "/sign-in", {"name": "made-up-001", "password": PASSWORD})
            self.assertTrue(signed_in.headers["Set-Cookie"].startswith("__Host-insonate="), "behind-proxy")
            self.assertEqual(server.ask("GET", "/metrics").status, 200)
            self.assertEqual(server.ask("GET", "/metrics", X_Forwarded_For="10.0.0.9").status, 403)
            self.assertEqual(server.ask("GET", "/metrics", X_Forwarded_For="10.0.0.9",
                                        Authorization="Bearer 0123456789abcdef").status, 200)
            for _ in range(30):
                server.ask("POST", "/sign-in", {"name": "x", "password": "y"}, X_Forwarded_For="10.0.0.9")
            again = {"name": "made-up-001", "password": PASSWORD}
            self.assertEqual(server.ask("POST", "/sign-in", again, X_Forwarded_For="10.0.0.8").status, 303)

    def test_faults_of_the_configuration_have_a_sentence(self):
        status, error, _ = refusal("--config", self.configuration(demo=True, listne="127.0.0.1:0"))
        self.assertEqual(status, 2)
        self.assertIn("listne", error)
        self.assertIn("without their dashes", error)
        self.assertEqual(refusal("--config", self.folder / "none.conf")[0], 2)
        short = self.folder / "short"
        short.write_text("secret")
        self.assertIn("shorter than 16", refusal("--demo", "--monitoring-token-file", short)[1])
        self.assertIn("none cannot be read", refusal("--demo", "--monitoring-token-file", self.folder / "none")[1])

    def test_faults_of_openid_connect_have_a_sentence(self):
        secret = self.folder / "secret"
        secret.touch(0o600)
        options = ["--demo", "--openid-issuer", "https://id.example.org", "--openid-client", "insonate", "--openid-name", "Hospital"]
        self.assertIn("needs openid-issuer, openid-client, openid-secret-file", refusal(*options)[1])
        self.assertIn("secret cannot be read, or its first line is empty", refusal(*options, "--openid-secret-file", secret)[1])
        self.assertIn("none cannot be read", refusal(*options, "--openid-secret-file", self.folder / "none")[1])
        secret.write_text("a secret\n")
        secret.chmod(0o640)
        self.assertIn(f"chmod 600 {secret}", refusal(*options, "--openid-secret-file", secret)[1])
        secret.chmod(0o600)
        options[2] = "http://id.example.org"
        self.assertIn("is not an https:// address", refusal(*options, "--openid-secret-file", secret)[1])

    def test_what_is_installed_fits_together(self):
        subprocess.run(["cmake", "--install", BUILD, "--component", "server", "--prefix", self.folder], check=True,
                       capture_output=True)
        unit = (self.folder / "lib/systemd/system/insonate-server.service").read_text()
        program = re.search(r"^ExecStart=(\S+) --config /etc/insonate/server.conf$", unit, re.M).group(1)
        self.assertEqual(program, str(self.folder / "bin/insonate-server"))
        self.assertNotIn("@bindir", unit)
        options = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
        settings = (self.folder / "share/insonate/server.conf").read_text()
        for option in set(re.findall(r"--([a-z-]+)", options)) - {"help", "version", "config"}:
            self.assertRegex(settings, rf"(?m)^#?{option} = ", "each option is a key that the file explains")
        uncommented = self.folder / "server.conf"
        uncommented.write_text(re.sub(r"(?m)^#(?=[a-z-]+ = )", "", settings))
        status, error, _ = refusal("--config", uncommented)
        self.assertEqual(status, 1, error)
        self.assertNotIn("configuration file", error)

    def test_the_server_listens_at_names_and_addresses_of_version_6(self):
        for listen, address in (("localhost:0", "127.0.0.1"), ("[::1]:0", "[::1]")):
            process = subprocess.Popen([SERVER, "--demo", "--listen", listen], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                       text=True)
            printed = ""
            for line in process.stdout:
                printed += line
                if "Serving" in line:
                    break
            process.terminate()
            _, errors = process.communicate(timeout=30)
            if listen != "localhost:0" and "cannot listen" in errors:
                self.skipTest("This computer has no IPv6.")
            self.assertIn(f" at http://{address}:", printed, errors)
        for listen in ("::1:8443", "::1"):
            status, error, _ = refusal("--demo", "--listen", listen)
            self.assertEqual(status, 1)
            self.assertIn("an IPv6 address in brackets", error)
        for listen in ("[::]:8443", "0.0.0.0:8443"):
            self.assertIn("Without a certificate", refusal("--demo", "--listen", listen)[1])

    def test_the_log_is_json_without_personal_data(self):
        with Server("--demo", "--listen", "127.0.0.1:0") as server:
            server.ask("POST", "/sign-in", {"name": "made-up-001", "password": "wrong password"})
            server.ask("GET", "/me?level=made-up-001")
        self.assertEqual([(one["route"], one["status"]) for one in server.log], [("/sign-in", 401), ("/me", 303)])
        self.assertEqual(set(server.log[0]), {"time", "level", "event", "method", "route", "status", "ms"})
        self.assertNotIn("made-up", json.dumps(server.log))


if __name__ == "__main__":
    if not shutil.which("openssl"):
        print("Skipped: openssl is not installed")
        sys.exit(77)
    # An old version of TLS is asked for on purpose.
    unittest.main(warnings="ignore")
