package rsal.ros2.rosbridge;

import java.nio.ByteBuffer;
import java.util.Base64;
import java.util.List;
import rsal.ros2.rosbridge.MessageValues.NotFitting;
import rsal.ros2.type.Primitive;
import tools.jackson.core.JsonGenerator;

/// Numbers and truth values of messages, one and several, as [rsal.ros2.cdr.RosMessage] has them.
final class PrimitiveArrays {
    private static final double MOST_EXACT = 1L << 53; // of integers that are written as floating point

    private PrimitiveArrays() {}

    /// Several, as JSON has them: a list, or of bytes also Base64.
    private interface Elements {
        int count();

        long integer(int i) throws NotFitting;

        double real(int i) throws NotFitting;
    }

    private record Listed(Primitive primitive, List<WireValue> values) implements Elements {
        @Override
        public int count() {
            return values.size();
        }

        @Override
        public long integer(int i) throws NotFitting {
            return PrimitiveArrays.integer(primitive, values.get(i));
        }

        @Override
        public double real(int i) throws NotFitting {
            return PrimitiveArrays.real(values.get(i));
        }
    }

    private record Packed(Primitive primitive, NumberArray numbers) implements Elements {
        @Override
        public int count() {
            return numbers.count();
        }

        @Override
        public long integer(int i) throws NotFitting {
            return numbers.isFloat()
                    ? PrimitiveArrays.integer(primitive, new WireValue.Real(numbers.real(i)))
                    : within(primitive, numbers.integer(i));
        }

        @Override
        public double real(int i) {
            return numbers.real(i);
        }
    }

    /// @return `byte[]`, `short[]`, `int[]`, `long[]`, `float[]` or `double[]`
    static Object read(Primitive primitive, WireValue value) throws InvalidMessage, NotFitting {
        Elements from = elements(primitive, value);
        int count = from.count();
        return switch (primitive) {
            case BOOL, BYTE, INT8, UINT8 -> bytes(from, count);
            case INT16, UINT16 -> {
                var array = new short[count];
                for (int i = 0; i < count; i++) {
                    array[i] = (short) from.integer(i);
                }
                yield array;
            }
            case INT32, UINT32 -> {
                var array = new int[count];
                for (int i = 0; i < count; i++) {
                    array[i] = (int) from.integer(i);
                }
                yield array;
            }
            case INT64, UINT64 -> {
                var array = new long[count];
                for (int i = 0; i < count; i++) {
                    array[i] = from.integer(i);
                }
                yield array;
            }
            case FLOAT32 -> {
                var array = new float[count];
                for (int i = 0; i < count; i++) {
                    array[i] = (float) from.real(i);
                }
                yield array;
            }
            case FLOAT64 -> {
                var array = new double[count];
                for (int i = 0; i < count; i++) {
                    array[i] = from.real(i);
                }
                yield array;
            }
        };
    }

    private static byte[] bytes(Elements from, int count) throws NotFitting {
        var array = new byte[count];
        for (int i = 0; i < count; i++) {
            array[i] = (byte) from.integer(i);
        }
        return array;
    }

    private static Elements elements(Primitive primitive, WireValue value) throws InvalidMessage, NotFitting {
        return switch (value) {
            case WireValue.Many(List<WireValue> values) -> new Listed(primitive, values);
            case WireValue.Numbers numbers -> new Packed(primitive, NumberArray.of(numbers));
            case WireValue.Text(String text)
            when primitive.size() == 1 -> {
                try {
                    var bytes = ByteBuffer.wrap(Base64.getDecoder().decode(text));
                    yield new Packed(primitive, NumberArray.of(new WireValue.Numbers(NumberArray.UINT8, bytes)));
                } catch (IllegalArgumentException e) {
                    throw new InvalidMessage("A text is not Base64: %s".formatted(e.getMessage()), e);
                }
            }
            default -> throw new NotFitting(value);
        };
    }

    static long integer(Primitive primitive, WireValue value) throws NotFitting {
        return switch (value) {
            case WireValue.Int(long number) -> within(primitive, number);
            case WireValue.Bool(boolean isTrue) -> isTrue ? 1 : 0;
            case WireValue.Real(double number)
            when number == Math.rint(number) && Math.abs(number) <= MOST_EXACT -> within(primitive, (long) number);
            default -> throw new NotFitting(value);
        };
    }

    /// Both the signed and the unsigned ones of a size, as `byte` is signed in ROS 1.
    private static long within(Primitive primitive, long number) throws NotFitting {
        int bits = Byte.SIZE * primitive.size();
        boolean isThere = bits == Long.SIZE || (number >= -(1L << (bits - 1)) && number < 1L << bits);
        if (!isThere) {
            throw new NotFitting(new WireValue.Int(number));
        }
        return switch (primitive) {
            case BYTE, UINT8 -> number & 0xff;
            case INT8 -> (byte) number;
            case UINT16 -> number & 0xffff;
            case INT16 -> (short) number;
            case UINT32 -> number & 0xffff_ffffL;
            case INT32 -> (int) number;
            default -> number;
        };
    }

    /// `null` is NaN, as rosbridge writes it, and infinity too.
    static double real(WireValue value) throws NotFitting {
        return switch (value) {
            case WireValue.Real(double number) -> number;
            case WireValue.Int(long number) -> number;
            case WireValue.Null _ -> Double.NaN;
            default -> throw new NotFitting(value);
        };
    }

    /// Writes the elements of an array.
    static void write(Primitive primitive, Object array, JsonGenerator out) {
        switch (array) {
            case byte[] all -> {
                for (byte each : all) {
                    if (primitive == Primitive.BOOL) {
                        out.writeBoolean(each != 0);
                    } else {
                        out.writeNumber(primitive == Primitive.INT8 ? (int) each : each & 0xff);
                    }
                }
            }
            case short[] all -> {
                for (short each : all) {
                    out.writeNumber(primitive == Primitive.INT16 ? (int) each : each & 0xffff);
                }
            }
            case int[] all -> {
                for (int each : all) {
                    out.writeNumber(primitive == Primitive.INT32 ? each : Integer.toUnsignedLong(each));
                }
            }
            case long[] all -> {
                for (long each : all) {
                    out.writeNumber(new java.math.BigInteger(
                            primitive == Primitive.INT64 ? Long.toString(each) : Long.toUnsignedString(each)));
                }
            }
            case float[] all -> {
                for (float each : all) {
                    out.writeNumber(each);
                }
            }
            case double[] all -> {
                for (double each : all) {
                    out.writeNumber(each);
                }
            }
            default -> throw new IllegalArgumentException("No array of a message: " + array.getClass());
        }
    }
}
