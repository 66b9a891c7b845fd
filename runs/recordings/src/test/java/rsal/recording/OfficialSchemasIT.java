package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.testkit.OfficialPython;

/// The official Python packages read a recording, checksums included, decode every message by the schemas in the file,
/// and find Foxglove's kinds of messages to be Foxglove's.
class OfficialSchemasIT {
    private static final String SCRIPT = """
            import sys, importlib, collections
            from google.protobuf.descriptor_pb2 import FileDescriptorSet
            from mcap.reader import make_reader
            from mcap_protobuf.decoder import DecoderFactory
            topics = collections.Counter()
            with open(sys.argv[1], "rb") as f:
                reader = make_reader(f, validate_crcs=True, decoder_factories=[DecoderFactory()])
                for schema, channel, message, decoded in reader.iter_decoded_messages():
                    topics[channel.topic] += 1
                    last = decoded
                assert sum(topics.values()) == reader.get_summary().statistics.message_count
                known = set()
                for schema in reader.get_summary().schemas.values():
                    files = FileDescriptorSet.FromString(schema.data)
                    for file in files.file:
                        if file.package != "foxglove":
                            continue
                        ours = file.message_type[0]
                        module = importlib.import_module(f"foxglove_schemas_protobuf.{ours.name}_pb2")
                        theirs = getattr(module, ours.name).DESCRIPTOR
                        known.add(ours.name)
                        for field in ours.field:
                            other = theirs.fields_by_number[field.number]
                            type_name = (other.message_type or other.enum_type)
                            assert (field.name, field.type, field.label == 3) == (other.name, other.type, other.is_repeated), field
                            assert field.type_name == ("." + type_name.full_name if type_name else ""), field
                        for enum in ours.enum_type:
                            words = [(v.name, v.number) for v in theirs.enum_types_by_name[enum.name].values]
                            assert [(v.name, v.number) for v in enum.value] == words, enum
            print(sorted(topics))
            print(sorted(known))
            """;

    @TempDir
    Path folder;

    @Test
    void decodeAll() throws Exception {
        Path file = folder.resolve("run.mcap");
        Recorded.runWithMore(Recorded.plan("hunt-and-prey", 7, 10), file);
        String printed = OfficialPython.run(SCRIPT, file.toString());
        assertThat(printed)
                .contains("/hunter-1/device/rear", "/hunter-1/device/weather")
                .contains("/tf", "/map", "/state", "/events", "/log", "/messages", "/world", "/scan")
                .contains("LaserScan", "FrameTransforms", "Grid", "Log", "SceneUpdate", "TriangleListPrimitive");
    }
}
