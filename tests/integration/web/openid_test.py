"""Signs users in to insonate-server by OpenID Connect with Debian's identity provider glewlwyd.

openid_test.py SERVER: SERVER is the program. Exit status 77: the package glewlwyd or openssl is not here.
"""

import http.client
import json
import pathlib
import re
import shutil
import socket
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.parse

SERVER = sys.argv.pop(1)
DATABASE_SCRIPT = pathlib.Path("/usr/share/dbconfig-common/data/glewlwyd/install/sqlite3")
MODULES = pathlib.Path("/usr/lib/glewlwyd")
PASSWORD = "made-up password"
CLIENT, SECRET = "insonate", "made-up-client-secret"


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def openssl(*arguments, text=None):
    return subprocess.run(["openssl", *arguments], input=text, check=True, capture_output=True, text=True).stdout


class Browser:
    """Keeps the cookies of one site. Follows no redirect."""

    def __init__(self, port):
        self.port, self.cookies = port, {}

    def ask(self, method, path, form=None, content=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        headers = {"Cookie": "; ".join(f"{name}={value}" for name, value in self.cookies.items()), "Host": f"localhost:{self.port}"}
        body = None
        if form is not None:
            body, headers["Content-Type"] = urllib.parse.urlencode(form), "application/x-www-form-urlencoded"
        if content is not None:
            body, headers["Content-Type"] = json.dumps(content), "application/json"
        connection.request(method, path, body, headers)
        answer = connection.getresponse()
        answer.text = answer.read().decode()
        connection.close()
        for cookie in answer.headers.get_all("Set-Cookie") or []:
            name, _, value = cookie.split(";")[0].partition("=")
            self.cookies[name] = value
        return answer


class Provider:
    """A running glewlwyd with a new database, at a loopback address."""

    def __init__(self, folder, port, return_address):
        self.port, self.issuer = port, f"http://localhost:{port}/api/oidc"
        database, settings = folder / "provider.db", folder / "provider.conf"
        sqlite3.connect(database).executescript(DATABASE_SCRIPT.read_text())
        settings.write_text(
            f'port={port}\nbind_address="127.0.0.1"\nexternal_url="http://localhost:{port}"\nlogin_url="login.html"\n'
            'api_prefix="api"\nlog_mode="console"\nlog_level="INFO"\ncookie_domain="localhost"\ncookie_secure=0\n'
            'session_expiration=3600\nsession_key="session"\nadmin_scope="g_admin"\nprofile_scope="g_profile"\n'
            f'user_module_path="{MODULES}/user"\nclient_module_path="{MODULES}/client"\n'
            f'user_auth_scheme_module_path="{MODULES}/scheme"\nplugin_module_path="{MODULES}/plugin"\n'
            f'hash_algorithm="SHA512"\ndatabase = {{ type = "sqlite3", path = "{database}" }};\n')
        self.log = open(folder / "provider.log", "w+")
        self.process = subprocess.Popen([shutil.which("glewlwyd"), f"--config-file={settings}"], stdout=self.log, stderr=self.log)
        self.administrator = Browser(port)
        self.wait()
        self.set_up(return_address)

    def wait(self):
        for _ in range(200):
            try:
                return self.change("POST", "/api/auth/", {"username": "admin", "password": "password"})
            except ConnectionError:
                time.sleep(0.1)
        raise RuntimeError(f"glewlwyd does not start: {pathlib.Path(self.log.name).read_text()}")

    def change(self, method, path, content=None):
        answer = self.administrator.ask(method, path, content=content)
        if answer.status != 200:
            raise RuntimeError(f"{method} {path}: {answer.status} {answer.text}")
        return answer

    def set_up(self, return_address):
        users = json.loads(self.change("GET", "/api/mod/user/database").text)
        users["parameters"]["data-format"]["email_verified"] = {"multiple": False, "read": True, "write": True}
        self.change("PUT", "/api/mod/user/database", users)
        self.change("PUT", "/api/mod/user/database/reset/")
        key = openssl("genrsa", "2048")
        verified = {"name": "email_verified", "user-property": "email_verified", "type": "boolean", "boolean-value-true": "1",
                    "boolean-value-false": "0", "mandatory": True}
        self.plugin = {"module": "oidc", "name": "oidc", "display_name": "OpenID Connect", "enabled": True, "parameters": {
            "iss": self.issuer, "jwt-type": "rsa", "jwt-key-size": "256", "key": key, "cert": openssl("rsa", "-pubout", text=key),
            "access-token-duration": 600, "refresh-token-duration": 600, "code-duration": 60, "auth-type-code-enabled": True,
            "auth-type-refresh-enabled": False, "subject-type": "public", "pkce-allowed": True, "pkce-required": True,
            "jwks-show": True, "oauth-as-iss-id": True, "email-claim": "mandatory", "claims": [verified]}}
        self.change("POST", "/api/mod/plugin/", self.plugin)
        self.change("POST", "/api/client/", {
            "client_id": CLIENT, "client_secret": SECRET, "name": "Insonate", "confidential": True, "enabled": True, "scope": [],
            "redirect_uri": [return_address], "authorization_type": ["code"], "token_endpoint_auth_method": ["client_secret_basic"]})
        self.change("POST", "/api/scope/", {"name": "email", "display_name": "E-mail", "password_required": False, "scheme": {}})

    def add_user(self, name, email, verified):
        self.change("POST", "/api/user/", {
            "username": name, "password": PASSWORD, "name": name, "email": email, "email_verified": "1" if verified else "0",
            "enabled": True, "scope": ["openid", "email", "g_profile"]})

    def end(self):
        self.process.terminate()
        self.process.wait(timeout=30)
        self.log.close()


class Server:
    """A running insonate-server with a made-up class."""

    def __init__(self, folder, port, issuer):
        secret = folder / "secret"
        secret.touch(0o600)
        secret.write_text(SECRET + "\n")
        self.port = port
        self.errors = open(folder / "server.log", "w+")
        self.process = subprocess.Popen(
            [SERVER, "--demo", "--listen", f"127.0.0.1:{port}", "--openid-issuer", issuer, "--openid-client", CLIENT,
             "--openid-secret-file", secret, "--openid-name", "Test Hospital"], stdout=subprocess.PIPE, stderr=self.errors, text=True)
        for line in self.process.stdout:
            if "Serving" in line:
                return
        raise RuntimeError(self.end())

    def end(self):
        self.process.terminate()
        self.process.wait(timeout=30)
        self.process.stdout.close()
        self.errors.seek(0)
        text = self.errors.read()
        self.errors.close()
        return text


class SignIn(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="insonate-openid-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        port = free_port()
        cls.provider = Provider(cls.folder, free_port(), f"http://localhost:{port}/sign-in/openid/return")
        cls.addClassCleanup(cls.provider.end)
        cls.server = Server(cls.folder, port, cls.provider.issuer)
        cls.set_email("made-up-001", "Anna@hospital.example")
        for name, email, verified in [("anna", "anna@hospital.example", True), ("ben", "anna@hospital.example", False),
                                      ("carl", "carl@hospital.example", True)]:
            cls.provider.add_user(name, email, verified)

    @classmethod
    def tearDownClass(cls):
        cls.log = cls.server.end()
        for secret in ("hospital.example", "anna", SECRET, PASSWORD):
            assert secret not in cls.log, f"{secret} is in the log:\n{cls.log}"

    @classmethod
    def set_email(cls, name, email):
        """Enters the address in an account, as an administrator does in a browser."""
        browser = Browser(cls.server.port)
        browser.ask("POST", "/sign-in", {"name": "made-up-administrator", "password": PASSWORD})
        people = browser.ask("GET", f"/people?search={name}").text
        account = re.search(r'href="(/people/[0-9a-f-]{36})"', people).group(1)
        code = re.search(r'name="code" value="([0-9a-f]+)"', people).group(1)
        form = {"code": code, "name": name, "full-name": "Made-up Anna", "email": email, "role": "trainee"}
        answer = browser.ask("POST", account, form)
        assert answer.status in (200, 303), answer.text

    def at_provider(self, browser, user, wanted="/me"):
        """Signs a user in at the provider, and returns the address to which the provider sends the browser back."""
        sent = browser.ask("GET", "/sign-in/openid?" + urllib.parse.urlencode({"next": wanted}))
        self.assertEqual(sent.status, 303, sent.text)
        address = urllib.parse.urlsplit(sent.headers["Location"])
        self.assertEqual((address.hostname, address.path), ("localhost", "/api/oidc/auth"))
        at_provider = Browser(self.provider.port)
        self.assertEqual(at_provider.ask("POST", "/api/auth/", content={"username": user, "password": PASSWORD}).status, 200)
        self.assertEqual(at_provider.ask("PUT", f"/api/auth/grant/{CLIENT}/", content={"scope": "openid email"}).status, 200)
        back = at_provider.ask("GET", f"{address.path}?{address.query}&g_continue")
        self.assertEqual(back.status, 302, back.text)
        returned = urllib.parse.urlsplit(back.headers["Location"])
        self.assertEqual((returned.hostname, returned.port), ("localhost", self.server.port))
        return f"{returned.path}?{returned.query}"

    def test_a_user_of_the_hospital_signs_in(self):
        browser = Browser(self.server.port)
        self.assertIn("Sign in with Test Hospital", browser.ask("GET", "/sign-in").text)
        back = self.at_provider(browser, "anna", "/me?level=x")
        signed_in = browser.ask("GET", back)
        self.assertEqual((signed_in.status, signed_in.headers["Location"]), (303, "/me?level=x"), signed_in.text)
        self.assertIn("Made-up Anna", browser.ask("GET", "/me").text)
        again = Browser(self.server.port)
        self.assertEqual(again.ask("GET", back).status, 400, "another browser")

    def test_a_code_is_redeemed_once(self):
        browser, thief = Browser(self.server.port), Browser(self.server.port)
        back = self.at_provider(browser, "anna")
        thief.cookies = dict(browser.cookies)
        self.assertEqual(browser.ask("GET", back).status, 303)
        self.assertEqual(thief.ask("GET", back).status, 502)
        self.assertEqual(thief.ask("GET", "/me").status, 303, "is not signed in")

    def test_users_without_an_account_or_a_verified_address_are_told(self):
        for user, sentence in [("ben", "to verify your e-mail address"), ("carl", "to enter this address in your account")]:
            browser = Browser(self.server.port)
            refused = browser.ask("GET", self.at_provider(browser, user))
            self.assertEqual(refused.status, 403, refused.text)
            self.assertIn(sentence, refused.text)

    def test_a_new_key_of_the_provider_is_read(self):
        browser = Browser(self.server.port)
        self.assertEqual(browser.ask("GET", self.at_provider(browser, "anna")).status, 303)
        key = openssl("genrsa", "2048")
        self.provider.plugin["parameters"].update({"key": key, "cert": openssl("rsa", "-pubout", text=key)})
        self.provider.change("PUT", "/api/mod/plugin/oidc", self.provider.plugin)
        self.provider.change("PUT", "/api/mod/plugin/oidc/reset/")
        renewed = Browser(self.server.port)
        self.assertEqual(renewed.ask("GET", self.at_provider(renewed, "anna")).status, 303)


if __name__ == "__main__":
    if not (shutil.which("glewlwyd") and DATABASE_SCRIPT.exists() and shutil.which("openssl")):
        print("Skipped: glewlwyd or openssl is not installed")
        sys.exit(77)
    unittest.main()
