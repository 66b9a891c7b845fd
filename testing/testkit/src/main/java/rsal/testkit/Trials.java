package rsal.testkit;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.ArgumentsProvider;
import org.junit.jupiter.params.provider.ArgumentsSource;
import org.junit.jupiter.params.support.ParameterDeclarations;

/// Arguments of a test that takes long, most often seeds of a run: each landing tries the first ones, and
/// `./rsal test --all` tries all of them.
///
/// ```java
/// @Trials({"1", "2", "3"})
/// void thePreyIsCaught(long seed) {
/// ```
@Target(ElementType.METHOD)
@Retention(RetentionPolicy.RUNTIME)
@ParameterizedTest
@ArgumentsSource(Trials.Provider.class)
public @interface Trials {
    /// Arguments of each trial, separated by commas.
    String[] value();

    /// How many of them each landing tries.
    int landing() default 1;

    /// Splits the arguments; JUnit converts them to the types of the test's parameters.
    final class Provider implements ArgumentsProvider {
        @Override
        public Stream<Arguments> provideArguments(ParameterDeclarations parameters, ExtensionContext context) {
            Trials trials = context.getRequiredTestMethod().getAnnotation(Trials.class);
            return Stream.of(trials.value())
                    .limit(Rounds.of(trials.landing(), trials.value().length))
                    .map(trial -> Arguments.of((Object[]) trial.split(", ", -1)));
        }
    }
}
