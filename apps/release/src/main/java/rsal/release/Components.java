package rsal.release;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/// The parts of others that a release has in it, with their licences: a bill of materials in CycloneDX 1.6
/// (cyclonedx.org), made of those that Maven and npm write, and the same as a table for people.
final class Components {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final String OURS = "rsal";

    private final List<JsonNode> all = new ArrayList<>();
    private final Map<String, String> texts = new TreeMap<>(); // by file

    /// Adds what a bill of materials lists, as Maven writes it.
    void add(Path bill) throws IOException {
        for (JsonNode component : JSON.readTree(Files.readString(bill)).path("components")) {
            all.add(component);
        }
    }

    /// Adds the libraries that a built page has in it, with the texts of their licences.
    ///
    /// @param list as Vite writes it (`build.license`): `[{"name", "version", "identifier", "text"}…]`
    void addBundled(Path list) throws IOException {
        for (JsonNode library : JSON.readTree(Files.readString(list))) {
            String name = library.path("name").asString("");
            String version = library.path("version").asString("");
            ObjectNode component = JSON.createObjectNode();
            component.put("type", "library");
            component.put("name", name);
            component.put("version", version);
            component.put("purl", "pkg:npm/%s@%s".formatted(name.replace("@", "%40"), version));
            component
                    .putArray("licenses")
                    .addObject()
                    .putObject("license")
                    .put("id", library.path("identifier").asString(""));
            all.add(component);
            String text = library.path("text").asString("");
            if (!text.isEmpty()) {
                texts.put("%s-%s/LICENSE".formatted(name.replace("@", "").replace('/', '-'), version), text);
            }
        }
    }

    /// @param version of RSAL
    /// @return the bill: without times and numbers of its own, so that the same parts give the same bytes
    byte[] bill(String version) {
        ObjectNode bill = JSON.createObjectNode();
        bill.put("bomFormat", "CycloneDX");
        bill.put("specVersion", "1.6");
        bill.put("version", 1);
        ObjectNode ours = bill.putObject("metadata").putObject("component");
        ours.put("type", "application");
        ours.put("name", OURS);
        ours.put("version", version);
        ours.putArray("licenses").addObject().putObject("license").put("id", "Apache-2.0");
        ArrayNode components = bill.putArray("components");
        sorted().forEach(components::add);
        return JSON.writerWithDefaultPrettyPrinter().writeValueAsString(bill).getBytes(StandardCharsets.UTF_8);
    }

    private Stream<JsonNode> sorted() {
        var unique = new TreeMap<String, JsonNode>();
        all.forEach(component -> unique.put(name(component) + "@" + version(component), component));
        return unique.values().stream();
    }

    /// Parts of others, one a line: name, version, licences.
    String table() {
        return sorted().filter(
                        component -> !component.path("group").asString("").equals(OURS))
                .map(component -> "| %s | %s | %s |%n"
                        .formatted(name(component), version(component), String.join(", or ", licences(component))))
                .collect(Collectors.joining("", "| part | version | licence |%n|---|---|---|%n".formatted(), ""))
                .replace("\r\n", "\n");
    }

    /// Parts that say no licence: these must not be passed on.
    List<String> unlicensed() {
        return sorted().filter(component -> licences(component).isEmpty())
                .map(Components::name)
                .toList();
    }

    private static String name(JsonNode component) {
        String group = component.path("group").asString("");
        String name = component.path("name").asString("");
        return group.isEmpty() ? name : group + (group.startsWith("@") ? "/" : ":") + name;
    }

    private static String version(JsonNode component) {
        return component.path("version").asString("");
    }

    private static Set<String> licences(JsonNode component) {
        var found = new LinkedHashSet<String>();
        for (JsonNode each : component.path("licenses")) {
            JsonNode licence = each.path("license");
            Stream.of(each.path("expression"), licence.path("id"), licence.path("name"))
                    .map(word -> word.asString(""))
                    .filter(word -> !word.isEmpty())
                    .findFirst()
                    .ifPresent(found::add);
        }
        return found;
    }

    /// Adds the texts of licences and notices that libraries carry as `licenses/LIBRARY/FILE`.
    ///
    /// @param libraries a folder of jars
    void addTexts(FileTree tree, Path libraries) throws IOException {
        texts.forEach((file, text) -> tree.add("licenses/" + file, text.getBytes(StandardCharsets.UTF_8)));
        try (Stream<Path> files = Files.list(libraries)) {
            List<Path> jars = files.filter(file -> file.toString().endsWith(".jar"))
                    .filter(file -> !name(file).startsWith(OURS + "-"))
                    .toList();
            for (Path jar : jars) {
                addTexts(tree, "licenses/" + name(jar).replaceFirst("\\.jar$", "") + "/", jar);
            }
        }
    }

    private static void addTexts(FileTree tree, String folder, Path jar) throws IOException {
        try (var zip = new ZipFile(jar.toFile())) {
            for (ZipEntry entry : zip.stream().filter(Components::isText).toList()) {
                String path = folder + entry.getName().replaceFirst("^META-INF/", "");
                if (!tree.files().containsKey(path)) { // one that is there twice
                    tree.add(path, zip.getInputStream(entry).readAllBytes());
                }
            }
        }
    }

    private static String name(Path file) {
        return String.valueOf(file.getFileName());
    }

    private static boolean isText(ZipEntry entry) {
        String name = entry.getName().toUpperCase(Locale.ROOT);
        return name.matches("(META-INF/)?(LICENSE|NOTICE|COPYING|ABOUT)[^/]*") && !name.endsWith(".CLASS");
    }
}
