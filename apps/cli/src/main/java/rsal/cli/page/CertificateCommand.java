package rsal.cli.page;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.MessageDigest;
import java.util.Base64;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;
import rsal.server.RunServer;

/// `rsal certificate`
@Command(
        name = "certificate",
        description = "Make a certificate for 'rsal run --listen' and its private key: DIR/certificate.pem and"
                + " DIR/key.pem. It is self-signed, so each browser warns once: compare its fingerprint"
                + " then.")
public final class CertificateCommand extends Subcommand {
    private static final String CERTIFICATE = "certificate.pem";
    private static final String KEY = "key.pem";
    private static final String PASSWORD = "RSAL_CERTIFICATE_PASSWORD"; // between us and keytool
    private static final Base64.Encoder LINES = Base64.getMimeEncoder(64, new byte[] {'\n'});

    @Parameters(
            paramLabel = "NAME",
            arity = "0..*",
            description =
                    "Names and addresses by which other machines reach this one. Default: its host name and addresses.")
    private List<String> names = List.of();

    @Option(
            names = "--out",
            paramLabel = "DIR",
            defaultValue = ".",
            description = "Folder for the files. Default: this folder.")
    private String out = ".";

    @Option(
            names = "--days",
            paramLabel = "N",
            defaultValue = "365",
            description = "Number of days for which it is valid. Default: ${DEFAULT-VALUE}.")
    private int days = 365;

    @Option(names = "--force", description = "Overwrite existing files.")
    private boolean force;

    @Override
    protected int run() throws InterruptedException {
        check(days >= 1 && days <= 3650, "--days must be from 1 to 3650, not '%d'.".formatted(days));
        check(
                names.stream().allMatch(name -> name.matches("[A-Za-z0-9.:-]+")),
                "A NAME has letters, digits, dots, colons and hyphens, like robots.example.org or 192.168.1.5.");
        Destination folder =
                Destination.of(out, List.of(CERTIFICATE, KEY), force).prepare();
        try {
            Path work = Files.createTempDirectory("rsal-certificate-");
            String password = RunServer.newToken();
            Path store = work.resolve("store.p12");
            keytool(store, password);
            KeyStore made = KeyStore.getInstance("PKCS12");
            made.load(new ByteArrayInputStream(Files.readAllBytes(store)), password.toCharArray());
            Files.delete(store);
            Files.delete(work);
            byte[] certificate = made.getCertificate("rsal").getEncoded();
            folder.write(Map.of(CERTIFICATE, pem("CERTIFICATE", certificate)));
            SecretFile.write(
                    folder.resolve(KEY),
                    pem(
                            "PRIVATE KEY",
                            made.getKey("rsal", password.toCharArray()).getEncoded()));
            print(folder, fingerprint(certificate));
            return Exit.SUCCESS;
        } catch (IOException | GeneralSecurityException e) {
            throw new Unreachable("No certificate can be made: %s.".formatted(e));
        }
    }

    private void keytool(Path store, String password) throws IOException, InterruptedException {
        List<String> all = names.isEmpty() ? ownNames() : names;
        String alternatives = all.stream()
                .map(name -> (name.matches("[0-9.]+|.*:.*") ? "ip:" : "dns:") + name)
                .collect(Collectors.joining(",", "san=", ""));
        var builder = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "keytool")
                                .toString(),
                        "-genkeypair",
                        "-alias",
                        "rsal",
                        "-keyalg",
                        "EC",
                        "-groupname",
                        "secp256r1",
                        "-validity",
                        Integer.toString(days),
                        "-dname",
                        "CN=" + all.getFirst().replace(":", "-"),
                        "-ext",
                        alternatives,
                        "-storetype",
                        "PKCS12",
                        "-keystore",
                        store.toString(),
                        "-storepass:env",
                        PASSWORD)
                .redirectErrorStream(true);
        builder.environment().put(PASSWORD, password);
        Process keytool = builder.start();
        keytool.getOutputStream().close();
        String reported = new String(keytool.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        if (keytool.waitFor() != 0) {
            throw new IOException("keytool says: " + reported.strip());
        }
    }

    private static List<String> ownNames() throws UnknownHostException {
        InetAddress own = InetAddress.getLocalHost();
        return List.of(own.getHostName(), "localhost", own.getHostAddress(), "127.0.0.1").stream()
                .distinct()
                .toList();
    }

    private static byte[] pem(String what, byte[] bytes) {
        return "-----BEGIN %s-----\n%s\n-----END %s-----\n"
                .formatted(what, LINES.encodeToString(bytes), what)
                .getBytes(StandardCharsets.US_ASCII);
    }

    private static String fingerprint(byte[] certificate) throws GeneralSecurityException {
        return HexFormat.ofDelimiter(":")
                .withUpperCase()
                .formatHex(MessageDigest.getInstance("SHA-256").digest(certificate));
    }

    private void print(Destination folder, String fingerprint) {
        String certificate = folder.resolve(CERTIFICATE).toString();
        String key = folder.resolve(KEY).toString();
        if (json) {
            printJson(Map.of("certificate", certificate, "key", key, "sha256", fingerprint));
            return;
        }
        out().println("%s%n%s%nSHA-256 fingerprint: %s".formatted(certificate, key, fingerprint));
        out().println("\nrsal run --listen 0.0.0.0 --certificate %s --key %s".formatted(certificate, key));
        out().flush();
    }
}
