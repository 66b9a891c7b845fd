package rsal.jadex;

import jadex.base.IPlatformConfiguration;
import jadex.base.PlatformConfigurationHandler;
import jadex.base.Starter;
import jadex.bridge.IExternalAccess;
import jadex.bridge.service.annotation.OnInit;
import jadex.bridge.service.types.cms.CreationInfo;
import jadex.commons.future.IFuture;
import jadex.micro.annotation.Agent;
import jadex.micro.annotation.Imports;
import jadex.platform.PlatformAgent;

/// A Jadex platform with what micro and BDI agents need and nothing else: no network, no windows, no files. Jadex's own
/// looks for parts on the whole class path, reads from the working directory which of them to start, and writes that
/// and a secret there.
@Agent
@Imports("jadex.platform.*") // where the inherited services are made
public final class LonelyPlatform extends PlatformAgent {
    /// Starts one. Takes a second or two the first time.
    public static IExternalAccess start() {
        IPlatformConfiguration how = PlatformConfigurationHandler.getMinimal();
        how.setPlatformName("rsal_***"); // and three letters at random, as several may run
        how.getExtendedPlatformConfiguration()
                .setConfigurationFile(LonelyPlatform.class.getName().replace('.', '/') + ".class");
        how.setValue("settings.readonly", true);
        how.setValue("readonly", true); // of the service for settings
        return Starter.createPlatform(how).get();
    }

    @OnInit
    @Override
    public IFuture<Void> init() {
        return begin("jadex/platform/service/library/LibraryAgent.class")
                .thenCompose(_ -> begin("jadex/micro/KernelMicroAgent.class"))
                .thenCompose(_ -> begin("jadex/bdiv3/KernelBDIV3Agent.class"))
                .thenCompose(_ -> IFuture.DONE);
    }

    private IFuture<IExternalAccess> begin(String part) {
        return agent.createComponent(new CreationInfo().setFilename(part));
    }
}
