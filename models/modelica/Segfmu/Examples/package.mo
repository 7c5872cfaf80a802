within Segfmu;
package Examples "Missions"
end Examples;
