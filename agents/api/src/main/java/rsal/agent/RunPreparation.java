package rsal.agent;

import java.util.List;
import java.util.ServiceLoader;

/// Many runs are to come: what each of them needs of its own, as a process, may be begun before the run is. Changes
/// nothing in a run. Ends with [#close], any thread may call it.
public interface RunPreparation extends AutoCloseable {
    /// Lets go of what no run has taken.
    @Override
    void close();

    /// Of all languages of this installation ([AgentLanguage#prepare]).
    ///
    /// @param atOnce how many runs go on side by side
    /// @param inAll how many there will be
    static RunPreparation of(int atOnce, int inAll) {
        List<RunPreparation> all =
                ServiceLoader.load(AgentLanguage.class, AgentLanguage.class.getClassLoader()).stream()
                        .map(language -> language.get().prepare(atOnce, inAll))
                        .toList();
        return () -> all.forEach(RunPreparation::close);
    }
}
