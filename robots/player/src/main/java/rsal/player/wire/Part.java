package rsal.player.wire;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;

/// How one component of a record looks on the wire. The reader has made sure that [#least] bytes are there.
sealed interface Part {
    Scalar INT = new Scalar(Integer.BYTES, ByteBuffer::getInt, (to, value) -> to.putInt((int) value));
    Scalar LONG = new Scalar(Long.BYTES, ByteBuffer::getLong, (to, value) -> to.putLong((long) value));
    Scalar FLOAT = new Scalar(Float.BYTES, ByteBuffer::getFloat, (to, value) -> to.putFloat((float) value));
    Scalar DOUBLE = new Scalar(Double.BYTES, ByteBuffer::getDouble, (to, value) -> to.putDouble((double) value));

    Elements BYTES = new Bytes();
    Elements FLOATS = new Floats();
    Elements DOUBLES = new Doubles();

    Object read(ByteBuffer from) throws MalformedException;

    void write(Object value, ByteBuffer to);

    /// [bytes]
    int size(Object value);

    /// Bytes that it has whatever it says.
    int least();

    interface Reader {
        Object read(ByteBuffer from);
    }

    interface Writer {
        void write(ByteBuffer to, Object value);
    }

    /// A number.
    record Scalar(int least, Reader reader, Writer writer) implements Part {
        @Override
        public Object read(ByteBuffer from) {
            return reader.read(from);
        }

        @Override
        public void write(Object value, ByteBuffer to) {
            writer.write(to, value);
        }

        @Override
        public int size(Object value) {
            return least;
        }
    }

    /// A record within one.
    record Nested(Layout<?> layout) implements Part {
        @Override
        public Object read(ByteBuffer from) throws MalformedException {
            return layout.read(from);
        }

        @Override
        public void write(Object value, ByteBuffer to) {
            layout.write((Record) value, to);
        }

        @Override
        public int size(Object value) {
            return layout.size((Record) value);
        }

        @Override
        public int least() {
            return layout.least();
        }
    }

    /// An array that always has as many elements.
    record Fixed(int times, Elements elements) implements Part {
        @Override
        public Object read(ByteBuffer from) throws MalformedException {
            return elements.read(times, from);
        }

        @Override
        public void write(Object value, ByteBuffer to) {
            if (elements.count(value) != times) {
                throw new IllegalArgumentException(
                        "An array of %d can't be sent; it has %d.".formatted(elements.count(value), times));
            }
            elements.write(value, to);
        }

        @Override
        public int size(Object value) {
            return elements.size(times, value);
        }

        @Override
        public int least() {
            return times * elements.least();
        }
    }

    /// An array that tells how many elements it has, twice.
    ///
    /// @param once the first of both counts stands elsewhere
    record Counted(boolean once, Elements elements) implements Part {
        @Override
        public Object read(ByteBuffer from) throws MalformedException {
            int first = from.getInt();
            int count = once ? first : from.getInt();
            long room = elements.least() == 0 ? 0 : from.remaining() / elements.least();
            if (count != first || count < 0 || count > room) {
                throw new MalformedException("An array can't have (%s, %s) elements in %d bytes."
                        .formatted(Integer.toUnsignedString(first), Integer.toUnsignedString(count), from.remaining()));
            }
            return elements.read(count, from);
        }

        @Override
        public void write(Object value, ByteBuffer to) {
            int count = elements.count(value);
            if (!once) {
                to.putInt(count);
            }
            to.putInt(count);
            elements.write(value, to);
        }

        @Override
        public int size(Object value) {
            return least() + elements.size(elements.count(value), value);
        }

        @Override
        public int least() {
            return once ? Integer.BYTES : 2 * Integer.BYTES;
        }
    }

    /// What an array has.
    sealed interface Elements {
        Object read(int count, ByteBuffer from) throws MalformedException;

        int count(Object value);

        void write(Object value, ByteBuffer to);

        int size(int count, Object value);

        /// Bytes that one has at least.
        int least();
    }

    /// Filled up with 0 to a multiple of 4.
    record Bytes() implements Elements {
        private static int filled(int count) {
            return (count + 3) & ~3;
        }

        @Override
        public Object read(int count, ByteBuffer from) throws MalformedException {
            if (from.remaining() < filled(count)) {
                throw new MalformedException("An array of %d bytes is not filled up.".formatted(count));
            }
            var bytes = new byte[count];
            from.get(bytes);
            from.position(from.position() + filled(count) - count);
            return bytes;
        }

        @Override
        public int count(Object value) {
            return ((byte[]) value).length;
        }

        @Override
        public void write(Object value, ByteBuffer to) {
            byte[] bytes = (byte[]) value;
            to.put(bytes);
            to.position(to.position() + filled(bytes.length) - bytes.length);
        }

        @Override
        public int size(int count, Object value) {
            return filled(count);
        }

        @Override
        public int least() {
            return 1;
        }
    }

    record Floats() implements Elements {
        @Override
        public Object read(int count, ByteBuffer from) {
            var floats = new float[count];
            from.asFloatBuffer().get(floats);
            from.position(from.position() + count * Float.BYTES);
            return floats;
        }

        @Override
        public int count(Object value) {
            return ((float[]) value).length;
        }

        @Override
        public void write(Object value, ByteBuffer to) {
            float[] floats = (float[]) value;
            to.asFloatBuffer().put(floats);
            to.position(to.position() + floats.length * Float.BYTES);
        }

        @Override
        public int size(int count, Object value) {
            return count * Float.BYTES;
        }

        @Override
        public int least() {
            return Float.BYTES;
        }
    }

    record Doubles() implements Elements {
        @Override
        public Object read(int count, ByteBuffer from) {
            var doubles = new double[count];
            from.asDoubleBuffer().get(doubles);
            from.position(from.position() + count * Double.BYTES);
            return doubles;
        }

        @Override
        public int count(Object value) {
            return ((double[]) value).length;
        }

        @Override
        public void write(Object value, ByteBuffer to) {
            double[] doubles = (double[]) value;
            to.asDoubleBuffer().put(doubles);
            to.position(to.position() + doubles.length * Double.BYTES);
        }

        @Override
        public int size(int count, Object value) {
            return count * Double.BYTES;
        }

        @Override
        public int least() {
            return Double.BYTES;
        }
    }

    record Records(Layout<?> layout) implements Elements {
        @Override
        public Object read(int count, ByteBuffer from) throws MalformedException {
            var records = new ArrayList<Record>(count);
            for (int i = 0; i < count; i++) {
                records.add(layout.read(from));
            }
            return List.copyOf(records);
        }

        @Override
        public int count(Object value) {
            return ((List<?>) value).size();
        }

        @Override
        public void write(Object value, ByteBuffer to) {
            for (Object each : (List<?>) value) {
                layout.write((Record) each, to);
            }
        }

        @Override
        public int size(int count, Object value) {
            int sum = 0;
            for (Object each : (List<?>) value) {
                sum += layout.size((Record) each);
            }
            return sum;
        }

        @Override
        public int least() {
            return layout.least();
        }
    }
}
