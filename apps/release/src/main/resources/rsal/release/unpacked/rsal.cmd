@echo off
rem Starts RSAL with the Java runtime beside this file; without one, with that of JAVA_HOME or of the PATH.
rem RSAL_CACHE=FOLDER says where the cache for fast starts is; RSAL_CACHE=off, that there is none.
setlocal
set "RSAL_TOP=%~dp0"
set "RSAL_TOP=%RSAL_TOP:~0,-1%"
set "RSAL_JAVA=%RSAL_TOP%\runtime\bin\java.exe"
if exist "%RSAL_JAVA%" goto cache
set "RSAL_JAVA=java"
if defined JAVA_HOME set "RSAL_JAVA=%JAVA_HOME%\bin\java.exe"
"%RSAL_JAVA%" -cp "%RSAL_TOP%\lib\rsal-cli.jar" rsal.cli.Main --version >nul 2>nul
if not errorlevel 1 goto cache
echo rsal: This release has no Java runtime, and '%RSAL_JAVA%' is not Java 25 or newer. 1>&2
echo rsal: Install Java 25 (https://adoptium.net), or let JAVA_HOME name one. 1>&2
exit /b 5

:cache
if "%RSAL_CACHE%"=="off" goto plain
if not defined RSAL_CACHE set "RSAL_CACHE=%RSAL_TOP%\cache"
if not exist "%RSAL_CACHE%\" mkdir "%RSAL_CACHE%" 2>nul
if exist "%RSAL_CACHE%\" goto start
if not defined LOCALAPPDATA goto plain
set "RSAL_CACHE=%LOCALAPPDATA%\rsal"
if not exist "%RSAL_CACHE%\" mkdir "%RSAL_CACHE%" 2>nul
if not exist "%RSAL_CACHE%\" goto plain

:start
"%RSAL_JAVA%" "@%RSAL_TOP%\lib\java.options" "-XX:AOTCache=%RSAL_CACHE%\start.aot" "-Drsal.cache=%RSAL_CACHE%\start.aot" "-Drsal.page=%RSAL_TOP%\page" "-Drsal.docs=%RSAL_TOP%\docs" "-Drsal.launcher=%RSAL_TOP%\rsal.cmd" -Drsal.terminal.out=ask -Drsal.terminal.err=ask -cp "%RSAL_TOP%\lib\rsal-cli.jar" rsal.cli.Main %*
exit /b %ERRORLEVEL%

:plain
"%RSAL_JAVA%" "@%RSAL_TOP%\lib\java.options" "-Drsal.page=%RSAL_TOP%\page" "-Drsal.docs=%RSAL_TOP%\docs" "-Drsal.launcher=%RSAL_TOP%\rsal.cmd" -Drsal.terminal.out=ask -Drsal.terminal.err=ask -cp "%RSAL_TOP%\lib\rsal-cli.jar" rsal.cli.Main %*
exit /b %ERRORLEVEL%
