package rsal.jade;

import jade.core.BaseNode;
import jade.core.HorizontalCommand;
import jade.core.IMTPException;
import jade.core.IMTPManager;
import jade.core.Node;
import jade.core.PlatformManager;
import jade.core.Profile;
import jade.core.ProfileImpl;
import jade.core.ResourceManager;
import jade.core.Service;
import jade.core.ServiceException;
import jade.core.SliceProxy;
import jade.mtp.TransportAddress;
import jade.util.leap.ArrayList;
import jade.util.leap.List;
import java.nio.file.FileSystems;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import org.jspecify.annotations.Nullable;

/// What JADE is to be like: a platform of one container that opens no socket, so that nobody else can join it or send
/// it anything. JADE's own transport listens on all addresses of the machine and makes objects of what it receives.
final class LonelyProfile extends ProfileImpl {
    private final NoNetwork network = new NoNetwork();
    private final ResourceManager threads = new DaemonThreads();
    private final String platform;

    /// @param platform name of it, as no other in this process has
    /// @param files where JADE may leave its files
    LonelyProfile(String platform, Path files) {
        super("localhost", -1, platform);
        this.platform = platform;
        setParameter(SERVICES, "jade.core.event.NotificationService;jade.core.messaging.TopicManagementService");
        setParameter(NO_MTP, "true");
        setParameter(DETECT_MAIN, "false"); // else it listens for others who look for a platform
        setParameter(NO_DISPLAY, "true");
        setParameter(FILE_DIR, files + FileSystems.getDefault().getSeparator());
        setParameter("jade_core_AgentContainerImpl_enablemonitor", "false");
    }

    /// The platform is about to end: what is still on its way reaches nobody.
    void end() {
        network.node.ending = true;
    }

    @Override
    protected IMTPManager getIMTPManager() {
        return network;
    }

    @Override
    public ResourceManager getResourceManager() {
        return threads;
    }

    /// Those that JADE makes itself never keep the process alive.
    private final class DaemonThreads implements ResourceManager {
        @Override
        public Thread getThread(int kind, String name, Runnable work) {
            return Thread.ofPlatform().daemon().name(platform + "-" + name).unstarted(work);
        }

        @Override
        public void initialize(Profile profile) {}

        @Override
        public void releaseResources() {}
    }

    /// All there is, is this node.
    private static final class NoNetwork implements IMTPManager {
        private final LonelyNode node = new LonelyNode();

        @Override
        public void initialize(Profile profile) {}

        @Override
        public void shutDown() {
            node.exit();
        }

        @Override
        public Node getLocalNode() {
            return node;
        }

        @Override
        public void exportPlatformManager(PlatformManager manager) {
            manager.setLocalAddress(new Nowhere().toString());
        }

        @Override
        public void unexportPlatformManager(PlatformManager manager) {}

        @Override
        public PlatformManager getPlatformManagerProxy() throws IMTPException {
            throw nobodyElse();
        }

        @Override
        public PlatformManager getPlatformManagerProxy(String address) throws IMTPException {
            throw nobodyElse();
        }

        @Override
        public void reconnected(PlatformManager manager) {}

        /// What JADE calls a proxy calls the node's own services here.
        @Override
        @SuppressWarnings("rawtypes") // as JADE has it
        public Service.Slice createSliceProxy(String service, Class type, Node where) throws IMTPException {
            try {
                SliceProxy proxy = Class.forName(service + "Proxy")
                        .asSubclass(SliceProxy.class)
                        .getDeclaredConstructor()
                        .newInstance();
                proxy.setNode(where);
                return proxy;
            } catch (ReflectiveOperationException e) {
                throw new IMTPException("JADE's service '%s' has no proxy.".formatted(service), e);
            }
        }

        @Override
        public List getLocalAddresses() {
            var addresses = new ArrayList();
            addresses.add(new Nowhere());
            return addresses;
        }

        @Override
        public TransportAddress stringToAddr(String address) throws IMTPException {
            throw nobodyElse();
        }

        private static IMTPException nobodyElse() {
            return new IMTPException("This platform has no other containers.");
        }
    }

    private static final class LonelyNode extends BaseNode {
        private final transient CountDownLatch exited = new CountDownLatch(1);
        private volatile boolean ending;

        LonelyNode() {
            super("here", true);
        }

        @Override
        public @Nullable Object accept(HorizontalCommand command) throws IMTPException {
            try {
                return serveHorizontalCommand(command);
            } catch (ServiceException e) {
                if (ending) {
                    return null;
                }
                throw new IMTPException("JADE's service '%s' failed.".formatted(command.getService()), e);
            }
        }

        /// Whether it has exited.
        ///
        /// @param hang whether to wait for that
        @Override
        public boolean ping(boolean hang) {
            if (hang) {
                try {
                    exited.await();
                } catch (InterruptedException _) {
                    Thread.currentThread().interrupt();
                }
            }
            return exited.getCount() == 0;
        }

        @Override
        public void interrupt() {}

        @Override
        public void exit() {
            exited.countDown();
        }
    }

    /// JADE wants an address, for people.
    private record Nowhere() implements TransportAddress {
        @Override
        public String getProto() {
            return "none";
        }

        @Override
        public String getHost() {
            return "localhost";
        }

        @Override
        public String getPort() {
            return "";
        }

        @Override
        public String getFile() {
            return "";
        }

        @Override
        public String getAnchor() {
            return "";
        }
    }
}
