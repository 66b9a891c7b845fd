package rsal.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class ComponentsTest {
    private static final String BILL = """
            {"components": [
              {"type": "library", "group": "org.slf4j", "name": "slf4j-api", "version": "2.0", "licenses": [{"license": {"id": "MIT"}}]},
              {"type": "library", "group": "rsal", "name": "rsal-data", "version": "0.1.0", "licenses": [{"license": {"id": "Apache-2.0"}}]},
              {"type": "library", "group": "a", "name": "two", "version": "1",
               "licenses": [{"license": {"id": "EPL-2.0"}}, {"license": {"name": "Apache 2"}}]},
              {"type": "library", "group": "a", "name": "chosen", "version": "1", "licenses": [{"expression": "(CDDL-1.1 OR GPL-2.0-only)"}]}
            ]}
            """;
    private static final String BUNDLED = """
            [{"name": "@codemirror/view", "version": "6.1", "identifier": "MIT", "text": "MIT License"}]
            """;

    @TempDir
    private Path folder;

    private final Components components = new Components();

    @BeforeEach
    void read() throws IOException {
        components.add(Files.writeString(folder.resolve("bom.json"), BILL));
        components.addBundled(Files.writeString(folder.resolve("licenses.json"), BUNDLED));
    }

    @Test
    void theTableNamesPartsOfOthersWithTheirLicences() {
        assertThat(components.table()).isEqualTo("""
                | part | version | licence |
                |---|---|---|
                | @codemirror/view | 6.1 | MIT |
                | a:chosen | 1 | (CDDL-1.1 OR GPL-2.0-only) |
                | a:two | 1 | EPL-2.0, or Apache 2 |
                | org.slf4j:slf4j-api | 2.0 | MIT |
                """);
        assertThat(components.unlicensed()).isEmpty();
    }

    @Test
    void theBillListsAllPartsOnce() throws IOException {
        components.add(folder.resolve("bom.json"));
        JsonNode bill = JsonMapper.shared().readTree(components.bill("0.1.0"));
        assertThat(bill.path("bomFormat").asString()).isEqualTo("CycloneDX");
        assertThat(bill.path("components")).hasSize(5);
        assertThat(bill.path("components").get(0).path("purl").asString()).isEqualTo("pkg:npm/%40codemirror/view@6.1");
        assertThat(bill.path("metadata").path("component").path("version").asString())
                .isEqualTo("0.1.0");
    }

    @Test
    void aPartWithoutALicenceIsReported() throws IOException {
        components.add(Files.writeString(
                folder.resolve("bare.json"), "{\"components\": [{\"name\": \"bare\", \"version\": \"1\"}]}"));
        assertThat(components.unlicensed()).containsExactly("bare");
    }

    @Test
    void textsOfLicencesAreTaken() throws IOException {
        Path jars = Files.createDirectory(folder.resolve("jars"));
        for (String name : new String[] {"slf4j-api.jar", "rsal-data.jar"}) {
            try (var jar = new ZipOutputStream(Files.newOutputStream(jars.resolve(name)))) {
                for (String file :
                        new String[] {"META-INF/LICENSE", "NOTICE.txt", "LICENSE", "org/LICENSE", "License.class"}) {
                    jar.putNextEntry(new ZipEntry(file));
                    jar.write(file.getBytes(StandardCharsets.UTF_8));
                }
            }
        }
        var tree = new FileTree();
        components.addTexts(tree, jars);
        assertThat(tree.files())
                .containsOnlyKeys(
                        "licenses/codemirror-view-6.1/LICENSE",
                        "licenses/slf4j-api/LICENSE",
                        "licenses/slf4j-api/NOTICE.txt");
    }
}
